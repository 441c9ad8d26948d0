"""Say what became of a run: why a node was killed, where time stands still, what went wrong."""

from __future__ import annotations

import os
import traceback
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from ..clocks.clock import NS
from ..clocks.frames import Place, Whereabouts, is_installed, node_frames
from ..clocks.installed import is_installed_file
from ..clocks.programs import Killed
from ..clocks.simulation import Simulation, Standstill
from ..clocks.watchdog import Stuck
from ..world.world import NotSimulated
from .kinds import ROS, language_of, words_in
from .source import Code

if TYPE_CHECKING:
    from .process import Process

__all__ = [
    "TimeStandsStill",
    "keep_those_of",
    "say_error",
    "say_killed",
    "say_uncalled",
    "say_where",
    "stands_still",
    "waits_for_a_rate",
    "where_it_was_kept",
]


class TimeStandsStill(RuntimeError):
    """The node keeps simulated time from passing. The message says where and how."""


def say_killed(node: Code, ros: int, seconds: float | None, patience: float, killed: Killed) -> str:
    """Say why a node of a ROS was killed ``patience`` seconds after Ctrl-C, and where its threads were."""
    at = "" if seconds is None else f" at {seconds:.10g} s"
    why = f"Does its loop check {words_in(node.filename, ros).asks}?"
    if killed.ignores:
        why = "The node ignores Ctrl-C: signal.signal(signal.SIGINT, signal.SIG_IGN)."
    elif waits_for_a_rate(node, ros, killed.waited):
        why = (
            "After Ctrl-C nothing wakes a Rate any more, and Python waits for the thread that is asleep in it. "
            "Use a Rate only in a daemon thread."
        )
    said = f"rosspin: Ctrl-C{at} did not end the node; it was killed {patience:g} s later{ROS[ros].killed_as}. {why}\n"
    return said + say_where(node, killed.waited)


def say_where(node: Code, waited: Sequence[Whereabouts]) -> str:
    """Say where the threads of a node were, a line for each."""
    lines = []
    for thread, places, _ in waited:
        place = _of_nodes([node], places)
        if not place and language_of(node.filename):
            continue  # where it was is not known
        where = f"was at {place.shown()}" if place else "had done its work and waited for other threads"
        lines.append(f"rosspin: {thread} {where}\n")
    return "".join(lines)


def waits_for_a_rate(node: Code, ros: int, waited: Sequence[Whereabouts]) -> bool:
    """Whether nothing but threads asleep on a Rate that nothing wakes keeps a node from its end."""
    kept = _keeping(node, waited)
    return bool(kept) and all(map(ROS[ros].is_asleep_on_a_rate, kept))


def keep_those_of(node: Code, stacks: Sequence[Whereabouts]) -> list[Whereabouts]:
    """Keep the stacks that are in a node's code."""
    return [each for each in stacks if _of_nodes([node], each.places)]


def where_it_was_kept(node: Code, waited: Sequence[Whereabouts]) -> Place | None:
    """Return the first place in a node's code that kept it from its end."""
    return next((_of_nodes([node], places) for places in _keeping(node, waited)), None)


def _keeping(node: Code, waited: Sequence[Whereabouts]) -> list[list[Place]]:
    """Find where in the node's code the threads are that Python waits for, but for those that wait for others."""
    return [places for _, places, daemon in waited if not daemon and _of_nodes([node], places)]


def _of_nodes(nodes: Sequence[Code], places: Sequence[Place]) -> Place | None:
    """Return the innermost place in a node's file or its folder, but not in what is installed there."""
    folders = tuple(name for node in nodes for name in (node.filename, f"{node.folder or node.filename}{os.sep}"))
    there = (place for place in places if place.filename.startswith(folders))
    return next((place for place in there if not is_installed_file(place.filename)), None)


def stands_still(nodes: Sequence[Code], ros: int, error: Standstill | Stuck, clock: Simulation) -> TimeStandsStill:
    now = f"simulated time stands still at {clock.now() / NS} s"
    fallback = clock.failed if isinstance(error, Stuck) else error.place
    place = _of_nodes(nodes, error.places) or (None if fallback else _of_nodes(nodes, clock.left))
    where = (f"{place.filename}:{place.line}" if place.line else place.filename) if place else fallback
    sleep = words_in(place.filename if place else "", ros).sleeps
    if isinstance(error, Stuck) and (error.waits or error.computed):
        where = place.shown() if place else fallback
        why = (
            f"because this has computed for {error.computed:.0f} s and let nothing else run meanwhile. "
            "Compute less at a time, or run the node on the wall clock."
            if error.computed
            else "because this waits in real time, which the simulation cannot see. "
            "Run the node on the wall clock, or remove what waits."
        )
    elif isinstance(error, Standstill) and error.threads:
        why = (
            f"because {error.threads:,} threads have not ended, as many as a run may have; this would have been one "
            f"more{ROS[ros].also_threads}. Start them outside of loops and callbacks, or end them."
        )
    else:
        there = f", in {place.function}" if place and place.function and not place.line else ""
        why = (
            f"because the node keeps running without sleeping{there}. "
            f"Sleep in every loop (rate.sleep(), {sleep}), and give timers and rates a period above 0."
        )
    return TimeStandsStill(f"{where}{': ' if where else ''}{now}, {why}")


def say_uncalled(processes: Sequence[Process], ended_early: bool) -> Iterator[str]:
    """Say why callbacks of processes that ended well, and maybe before Ctrl-C, were never called.

    ``cpp/js/alone.mjs`` says the same of a node in C++ that is alone in a page.
    """
    for process in processes:
        world = process.world
        if world.exit_status or world.errors:
            continue
        for what in dict.fromkeys(world.lost):
            if what == "node":
                lost = "last ros::NodeHandle was destroyed before ros::spin(), which has shut the node down"
            else:
                lost = f"{what} was destroyed before it could call back"
            yield f"The {lost}. Keep it in a member of the class, or in main."
        if ended_early and world.waiting > 0:
            spins = words_in(process.node.filename, world.ros).spins
            if ROS[world.ros].timers_are_threads and not language_of(process.node.filename):
                yield f"The node had a timer, which was never called. Is {spins} missing at its end?"
            else:
                yield (
                    "Nothing spun the node, so none of its timers, subscriptions and services called back. "
                    f"Is {spins} missing at its end?"
                )


def say_error(error: Exception) -> str:
    """Say what error ended or prevented a run, with the line of the node's file if it has one."""
    if isinstance(error, SyntaxError):
        return "".join(traceback.format_exception_only(error)).strip()
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, NotSimulated) and error.place:
        return f"{error.place}: {error}"
    if isinstance(error, NotSimulated):
        trace = node_frames((error.__cause__ or error).__traceback__)
        lines = [each for each in traceback.walk_tb(trace) if not each[0].f_code.co_filename.startswith("<frozen")]
        lines = [each for each in lines if not is_installed(each[0])] or lines
        return f"{lines[-1][0].f_code.co_filename}:{lines[-1][1]}: {error}" if lines else str(error)
    return str(error)
