"""What the executors of a run do, step by step: what is ready, who is called, what waits and why."""

from __future__ import annotations

import inspect
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from types import CodeType
from typing import Any, NamedTuple

from ..clocks.clock import NS
from ..clocks.frames import trail
from ..clocks.simulation import PacedSimulation
from ..clocks.stacks import current
from ..rclpy.callback_groups import ReentrantCallbackGroup
from ..rclpy.executors import Executor, MultiThreadedExecutor
from ..rclpy.parameter_service import ParameterService
from ..rclpy.services import Client
from ..rclpy.task import Task
from ..rclpy.timer import Rate, Timer
from ..world.graph import TickLog

__all__ = ["Scenes"]

# How many steps are kept, the first ones, and of a node with how many callbacks at most.
_MOST = 300
_MOST_CALLBACKS = 30

_OURS = str(Path(__file__).parents[1])  # done callbacks of the stand-in's own are no steps


class _Call(NamedTuple):
    """A call that has begun: of what, by whom, in which thread and task. A task that is not executing awaits."""

    entity: Any
    executor: Executor
    thread: int
    task: Task


class _Asked:
    """A function that was handed to an executor, such as a done callback; ``tasks`` are those that have not begun."""

    callback_group = None
    _executor_event = False

    def __init__(self, callback: Any) -> None:
        self.callback = callback
        self.tasks: list[Task] = []

    @property
    def is_ready(self) -> bool:
        return any(not task.cancelled() for task in self.tasks)


class Scenes:
    """The steps of a run of ROS 2, in which a step is noted whenever an executor does something or the time goes on.

    The run has to go on :attr:`clock`, and to record its ticks in ``log``. Lines are those of the file ``filename``.
    ``pace(when)`` is called before the time becomes ``when`` (ns).
    """

    def __init__(self, log: TickLog, filename: str, pace: Callable[[int], object] = lambda when: None) -> None:
        log.tell = self.tell
        self.clock = PacedSimulation(self._before)
        self._filename = filename
        self._pace = pace
        self._ready: dict[Executor, list[Any]] = {}  # what each has found, and not called yet
        self._callbacks: dict[Any, int] = {}  # timers and the like: their numbers
        self._names: list[tuple[str, int]] = []  # of the callbacks, with the numbers of their groups
        self._groups: dict[Any, tuple[int, str]] = {}
        self._threads: dict[int, tuple[int, str]] = {}
        self._asked: dict[Any, _Asked] = {}  # by their code, and by their tasks
        self._calls: list[_Call] = []  # those that have not ended
        self._steps: list[list[Any]] = []
        self._rings: list[list[Any]] = []

    def data(self, status: int) -> dict[str, Any] | None:
        """Return what a page draws of a run that has ended with ``status``, ready for JSON: see web/src/protocol.js.

        It is None where nobody spins or waits. A step is a time (s), a sentence, the ready ones in their order, of each
        thread its number, the callback in it (-1: none) and its line (0: none of the file), and how each callback is.
        """
        if not (self._steps or self._rings):
            return None
        end = "The rest is not shown." if self._is_full else f"The node has ended, with status {status}."
        steps = [*self._steps, [self.clock.seconds(), end, [], [], []]]
        return {
            "threads": [name for _, name in self._threads.values()],
            "groups": [name for _, name in self._groups.values()],
            "callbacks": self._names,
            "steps": steps,
            "rings": self._rings,
        }

    def tell(self, what: str, subject: Any, more: Any = None) -> None:
        """Note what an executor, a thread or a signal does. This is called on the thread that it happens on."""
        if what == "ring":
            self._rings.append(subject)
        if what == "ring" or self._is_full or self.clock.is_over:
            return
        here = threading.current_thread().name
        if isinstance(subject, Task):
            if what == "asks" and (code := _code(more)) and not code.co_filename.startswith(_OURS):
                asked = self._asked[subject] = self._asked.setdefault(code, _Asked(more))
                asked.tasks.append(subject)
                self._note(f"{here} hands {self._say([asked])} to the executor, which calls it in its next round.")
            if what == "asks" or subject not in self._asked:
                return
            task, subject = subject, self._asked[subject]
            if what == "calls":
                subject.tasks.remove(task)
                self._calls.append(_Call(subject, more, threading.get_ident(), task))
                self._note(f"{here} calls {self._say([subject])}.", _begin(subject, self._filename))
                return
        match what:
            case "looks":
                self._ready[subject] = []
            case "finds":
                self._say(_entities(subject))  # which gives them numbers in their order
                self._ready[subject] = [entity for entity in _entities(subject) if entity in more]
                if self._ready[subject]:
                    self._note(f"The executor finds what is ready: {self._say(self._ready[subject])}.")
            case "calls":
                self._ready[more] = [each for each in self._ready.get(more, ()) if each is not subject]
                task = next(task for task, entity, _ in more._tasks if entity is subject and task.executing())
                self._calls.append(_Call(subject, more, threading.get_ident(), task))
                late = self.clock.now() - subject.expected if isinstance(subject, Timer) else 0
                lateness = f", {late / NS:g} s late" if late > 0 else ""
                sets = ". That sets the event for which the loop sleeps" if isinstance(_owner(subject), Rate) else ""
                self._note(f"{here} calls {self._say([subject])}{lateness}{sets}.", _begin(subject, self._filename))
            case "ends" if calls := [call for call in self._calls if call.entity is subject]:
                # A coroutine may end in another thread than the one in which it began.
                self._calls.remove(min(calls, key=lambda call: call.thread != threading.get_ident()))
                self._note(f"{self._say([subject])} ends.")
            case "wakes":
                why = "the event is set" if isinstance(subject, Timer) else "what it waited for is there"
                self._note(f"{here} goes on: {why}.")
            case "says":
                self._note(f"{here} {subject}")

    @property
    def _is_full(self) -> bool:
        return len(self._steps) >= _MOST or len(self._callbacks) > _MOST_CALLBACKS

    def _before(self, when: int) -> None:
        if when > self.clock.now() and self._ready and not self._is_full:
            running = list(dict.fromkeys(call.entity for call in self._calls if call.task.executing()))
            verb = "is" if len(running) == 1 else "are"
            what = f"{self._say(running)} {verb} at work" if running else "No callback runs"
            self._note(f"{what} until {when / NS:g} s.", until=when)
        self._pace(when)

    def _note(self, said: str, line: int = 0, until: int = 0) -> None:
        """Note a step, after which nothing changes ``until`` then. ``line`` is the calling thread's, if it is known."""
        executors = {entity: executor for executor in self._ready for entity in _entities(executor)}
        self._say(executors)
        handed = [each for each in self._callbacks if each._executor_event and each in executors]
        ready = [each for found in self._ready.values() for each in found if each not in handed]
        ready += [each for each in self._callbacks if isinstance(each, _Asked) and each.is_ready]
        order = [self._callbacks[each] for each in (*handed, *ready)]
        how = [self._how(each, executors.get(each), until) for each in self._callbacks]
        self._steps.append([self.clock.seconds(), said, order, list(self._where(line)), how])

    def _where(self, here: int) -> Iterator[tuple[int, int, int]]:
        """Find for each thread its number, the callback in it and its line."""
        for stack in self.clock.suspended():
            thread = threading._active.get(stack.ident)  # type: ignore[attr-defined]
            if thread is None:
                continue
            number, _ = self._threads.setdefault(stack.ident, (len(self._threads), thread.name))
            calls = (call for call in reversed(self._calls) if call.thread == stack.ident and call.task.executing())
            inside = next((call.entity for call in calls), None)
            is_here = stack is current()
            frames = trail(sys._getframe()) if is_here else stack.trail
            line = next((line for code, _, line in frames if code.co_filename == self._filename), 0)
            yield number, self._callbacks.get(inside, -1), is_here and here or line

    def _say(self, entities: Iterable[Any]) -> str:
        """Name callbacks; a new one gets a number, and so does its group."""
        for entity in entities:
            if entity not in self._callbacks:
                group = entity.callback_group
                number, _ = self._groups.setdefault(group, (len(self._groups), self._group(group)))
                name, names = _name(entity), [name for name, _ in self._names]
                same = sum(other.partition(" #")[0] == name for other in names)
                self._callbacks[entity] = len(names)
                self._names.append((f"{name} #{same + 1}" if same else name, number))
        return ", ".join(self._names[self._callbacks[entity]][0] for entity in entities)

    def _group(self, group: Any) -> str:
        if group is None:
            return "Handed to the executor: in no group"
        nodes = [node for executor in self._ready for node in executor.get_nodes()]
        at_once = "many at a time" if isinstance(group, ReentrantCallbackGroup) else "one at a time"
        if any(group is node._rate_group for node in nodes):
            return f"Group of Rates: {at_once}"
        if any(group is node.default_callback_group for node in nodes):
            return f"Default group: {at_once}"
        own = sum(name.startswith("Own") for _, name in self._groups.values())
        return f"Own group {own + 1}: {at_once}"

    def _how(self, entity: Any, executor: Executor | None, until: int) -> str:
        """Say how a callback is if nothing changes ``until`` then: it runs, waits and why, or when it is due."""
        if isinstance(entity, _Asked):
            executor = next((call.executor for call in self._calls if call.entity is entity), None)
        calls = [call.entity for call in self._calls if call.executor is executor and call.task.executing()]
        if isinstance(entity, _Asked) and entity not in calls:
            return "awaits" if executor else "ready" if entity.is_ready else ""
        if entity in calls or executor is None:
            return "runs" if entity in calls else ""
        if any(call.entity is entity for call in self._calls):
            return "awaits, and keeps its group"
        threads = executor._executor._max_workers if isinstance(executor, MultiThreadedExecutor) else 1
        if entity._executor_event:
            return "ready" if len(calls) < threads else "waits for a free thread"
        since = ""
        if not isinstance(entity, Timer):
            is_due = bool(getattr(entity, "messages", ()) or getattr(entity, "triggered", False))
        elif not (is_due := entity.is_due()) and entity.is_flowing():
            due = entity.time_left() + self.clock.now()
            since, is_due = f"from {due / NS:g} s on ", due < until
            if not is_due:
                return f"due at {due / NS:g} s"
        if not is_due:
            return ""
        if threads == 1 and calls:
            return f"waits {since}for the thread, which is in {self._say(calls)}"
        if not entity.callback_group.can_execute(entity):
            taken = [call.entity for call in self._calls if call.entity.callback_group is entity.callback_group]
            return f"waits {since}for its group, which is taken by {self._say(taken)}"
        return "ready" if entity in self._ready[executor] else "waits for the next round"


def _code(callback: Any) -> CodeType | None:
    code: CodeType | None = getattr(inspect.unwrap(getattr(callback, "func", callback)), "__code__", None)
    return code


def _entities(executor: Executor) -> list[Any]:
    """What an executor may call, in its order, but the services for parameters."""
    nodes = executor.get_nodes()
    found = [waitable for node in nodes for waitable in node._rosspin_waitables if waitable not in node._rosspin_events]
    for node in nodes:
        found += [*node._timers, *node._subscriptions, *node._guards, *node._clients]
        found += [each for each in node._services if not isinstance(_owner(each), ParameterService)]
    return found


def _owner(entity: Any) -> Any:
    """What the callback is a method of."""
    return getattr(getattr(entity, "callback", None), "__self__", None)


def _name(entity: Any) -> str:
    if isinstance(_owner(entity), Rate):
        return "the Rate's timer"
    if isinstance(entity, Client):
        return f"the answer of {entity.end.topic}"
    callback = getattr(entity, "callback", None) or entity
    return str(getattr(callback, "__name__", type(callback).__name__))


def _begin(entity: Any, filename: str) -> int:
    """The line in the file where a callback begins; 0 if it is of another file."""
    code = _code(getattr(entity, "callback", None) or entity)
    return code.co_firstlineno if code and code.co_filename == filename else 0
