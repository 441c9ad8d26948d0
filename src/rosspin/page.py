"""Run a node in a web page: in simulated time that keeps pace with real time, in the page's own Python (Pyodide).

``web/worker.js`` calls :func:`run`. Nothing here is needed, or can run, outside of a browser.
"""

from __future__ import annotations

import io
import json
import os
import signal
import sys
from collections.abc import Callable, Sequence
from contextlib import redirect_stderr, redirect_stdout
from itertools import groupby
from typing import Any

from js import performance
from pyodide.ffi import run_sync

from .clock import NS
from .measures import describe_timeline
from .rospy.threads import own_frames
from .rospy.world import NotSimulated, World, world
from .run import Node, Tick, TimeStandsStill, load_source, run_simulated, say_error
from .simulation import PacedSimulation, Simulation
from .watchdog import Stuck, Watchdog

__all__ = ["run"]

# A plot shows no more ticks than this, the last ones.
_MOST_TICKS = 2000


def run(source: str, filename: str, seconds: float, args: Sequence[str], speed: float, page: Any) -> str:
    """Run the node in the text ``source`` for ``seconds``, ``speed`` times as fast as real time; 0: at once.

    ``args`` are its command line. Private parameters there need PyYAML, which the page does not have.

    ``page`` is a JavaScript object: its ``print(text, isError)`` is given what the node prints and its
    ``tick(source, number, expected, real)`` each tick that begins (s), both as they happen; ``wait(ms)`` is a promise
    that is kept after so long. The result, as JSON: the exit ``status``, the last ``ticks`` with their durations, their
    ``count``, and a text ``alternative`` to their plot. Errors end on the console and give status 1.
    """
    there = _There(page, speed)
    environment = dict(os.environ)
    with redirect_stdout(_Stream(page, False)), redirect_stderr(_Stream(page, True)):
        try:
            node = there.seen_by(load_source(source, filename))
            result = run_simulated(node, seconds, list(args), True, there.simulation, _Watchdog)
        except (ValueError, SyntaxError, NotSimulated, TimeStandsStill) as error:
            print(say_error(error), file=sys.stderr)
            if isinstance(error, SyntaxError):
                print("Python could not read this line, so nothing ran.", file=sys.stderr)
            return json.dumps({"status": 1})
        finally:
            os.environ.clear()  # the next run in this page is to find what this one found
            os.environ.update(environment)
        for hint in dict.fromkeys(map(_hint, there.world.errors if there.world else ())):
            if hint:
                print(hint, file=sys.stderr)
    return json.dumps(
        {
            "status": result.status,
            "count": len(result.ticks),
            "ticks": [[*tick[:4], tick.duration if tick.duration >= 0 else 0] for tick in result.ticks[-_MOST_TICKS:]],
            "alternative": _describe(result.ticks),
        }
    )


class _There:
    """A run's side that the page sees: its clock, which keeps pace with the page's, and its ticks as they begin."""

    def __init__(self, page: Any, speed: float) -> None:
        self.world: World | None = None
        self.simulation: Simulation = PacedSimulation(self._wait) if speed else Simulation()
        self._page = page
        self._speed = speed
        self._start = performance.now()
        self._shown = 0

    def seen_by(self, node: Node) -> Node:
        def main() -> None:
            self.world = world()
            node.main()

        return node._replace(main=main)

    def _wait(self, when: int) -> None:
        self._show_ticks()
        ahead = self._start + when / NS * 1e3 / self._speed - performance.now()
        if ahead > 0:
            run_sync(self._page.wait(ahead))

    def _show_ticks(self) -> None:
        ticks = self.world.ticks if self.world else None
        for source, number, expected, real, _ in (ticks or ())[self._shown :]:
            self._page.tick(source, number, expected / NS, real / NS)
            self._shown += 1


class _Stream(io.TextIOBase):
    encoding = "utf-8"

    def __init__(self, page: Any, is_error: bool) -> None:
        self._page = page
        self._is_error = is_error

    def write(self, text: str) -> int:
        self._page.print(text, self._is_error)
        return len(text)


class _Watchdog(Watchdog):
    """Without threads: ``web/worker.js`` interrupts Python again and again while it does not give way."""

    def __enter__(self) -> _Watchdog:
        self._previous = signal.signal(signal.SIGINT, self._on_interrupt)
        return self

    def __exit__(self, *error: object) -> None:
        signal.signal(signal.SIGINT, self._previous)

    def _on_interrupt(self, number: int, frame: Any) -> None:
        if self.look(frame):
            raise Stuck


def _describe(ticks: tuple[Tick, ...]) -> str:
    by_source: Callable[[Tick], str] = lambda tick: tick.source  # noqa: E731
    groups = groupby(sorted(ticks, key=by_source), by_source)
    return " ".join(describe_timeline(source, list(group)) for source, group in groups)


def _hint(error: BaseException) -> str:
    """What a reader may want to know of an error, beside its own words; "" if there is nothing to say."""
    if isinstance(error, ModuleNotFoundError):
        return (
            f"This page has rospy's stand-in and Python's standard library, but no {error.name}. "
            "Run the node on your own computer: python -m rosspin run FILE"
        )
    ours = error.__traceback__ is not None and _ends_in_rospy(error)
    if ours and isinstance(error, ZeroDivisionError):
        return "There is no frequency of 0 Hz and no period of 0 s: give rospy.Rate and rospy.Timer more than 0."
    if ours and isinstance(error, AttributeError) and error.name == "to_sec":
        return "The period of a rospy.Timer is a Duration: rospy.Timer(rospy.Duration(0.5), callback)"
    return ""


def _ends_in_rospy(error: BaseException) -> bool:
    """Whether an error was raised by the stand-in, not by a line of the node."""
    trace = error.__traceback__
    while trace and trace.tb_next:
        trace = trace.tb_next
    return trace is not None and own_frames(trace) is None
