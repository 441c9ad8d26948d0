"""Threads that wait for each other: for locks, for each other's end, for answers. Nothing but a ring is told."""

from __future__ import annotations

from ..clocks.frames import node_place, outer_place, places
from ..clocks.simulation import Simulation
from ..clocks.stacks import Stack, keeper, thread_name
from ..world.watcher import Watcher

__all__ = ["explain_threads"]

_LOCK = "a lock that"

_ORDER = "Take the locks in the same order everywhere."
_HOLDING = "Hold no lock while you wait for a thread that needs it."
_NEITHER = "One of them has to continue without waiting for the other."
_TWICE = "A threading.Lock cannot be taken twice by one thread: release it first, or use an RLock."


def explain_threads(clock: Simulation, watcher: Watcher | None = None) -> str:
    """Say which threads wait for each other, as lines; nothing if none do.

    ``watcher`` is told of each ring, for a picture of it.
    """
    lines: list[str] = []
    seen: set[Stack] = set()
    for stack in clock.suspended():
        path: dict[Stack, str] = {}
        while stack not in path and stack not in seen and (step := _step(stack)):
            path[stack], stack = step
        if stack in path:
            ring = list(path)[list(path).index(stack) :]
            lines += ["deadlock. This can never continue:", *(line for each in ring for line in _say(each, path[each]))]
            if watcher:
                watcher.rings({"links": [[thread_name(each), f"waits for {path[each]}"] for each in ring], "to": 0})
            locks = [path[each].startswith(_LOCK) for each in ring]
            lines.append(
                _NEITHER if not any(locks) else _TWICE if len(ring) == 1 else _ORDER if all(locks) else _HOLDING
            )
        seen |= path.keys()
    return "".join(f"rosspin: {line}\n" for line in lines)


def _step(stack: Stack) -> tuple[str, Stack] | None:
    """Return what a stack waits for, and the stack that would give it; None if that is not known."""
    if not stack.waits:
        return None
    if stack.needs:
        what, giver = stack.needs[0], stack.needs[1]()
        return (f"{what}, which {thread_name(giver)} has to give", giver) if isinstance(giver, Stack) else None
    if found := keeper(stack):
        holder, is_end = found
        name = thread_name(holder)
        return (f"the end of {name}" if is_end else f"{_LOCK} {name} holds"), holder
    if stack.lock and stack.lock.holder is stack:
        # Events, conditions and the like wait for a lock that they have taken themselves, until someone releases it.
        place = outer_place(places(stack.trail))
        return (f"{_LOCK} it holds", stack) if place and node_place([place]) else None
    return None


def _say(stack: Stack, what: str) -> list[str]:
    place = node_place(places(stack.trail))
    at = [f"    at {place.shown()}"] if place else []
    return [f"  {thread_name(stack)} waits for {what}", *at]
