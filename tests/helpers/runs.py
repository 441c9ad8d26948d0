"""Runs of scenarios on real clocks for the tests of a module, begun as the machine can take them, and judged."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Self

import pytest

from . import expectations
from .admission import Admission
from .corpus import Scenario, closest, read, recorded, simulated
from .lacking import LACKS
from .outcomes import Outcome
from .runtimes import Machine
from .verdicts import Control, inconclusive

# More at a time would not begin earlier, on any machine that we know.
AT_MOST = 8

Case = tuple[str, Scenario]


def asked_for(request: pytest.FixtureRequest) -> list[dict[str, Any]]:
    """The parameters of each test of this module that the session runs."""
    here = [item for item in request.session.items if isinstance(item, pytest.Function) and item.path == request.path]
    return [item.callspec.params for item in here if hasattr(item, "callspec")]


class _Beside(Control):
    """One control beside all runs of a module, which remembers when the machine stalled."""

    def __init__(self) -> None:
        super().__init__()
        self._stalls: list[tuple[float, float]] = []

    def called(self, took: float, waited: float) -> None:
        super().called(took, waited)
        if self._stretch:
            self._stalls.append((time.monotonic(), self._stretch))

    def since(self, begin: float) -> float:
        """For how long (s), at the longest, since that moment."""
        return max((min(stretch, now - begin) for now, stretch in self._stalls if now > begin), default=0.0)


class Runs:
    """The consoles of cases. Those named at first are run ahead, side by side; any other when it is asked for.

    A scenario says itself when it has stood still, but not if it ends immediately after that: then the control does.
    """

    def __init__(self, runtimes: Iterable[str], cases: Sequence[Case], patience: float = 0.0) -> None:
        there = [name for name in runtimes if name not in LACKS or not LACKS[name]()]
        self._admission = Admission(patience)
        self._beside = _Beside()
        self._beside.__enter__()
        self._machine = Machine(there)
        self._pool = ThreadPoolExecutor(AT_MOST)
        self._begun: dict[Case, list[Future[str]]] = {}
        for runtime, scenario in cases:
            if runtime in there:
                future = self._pool.submit(self._run, runtime, scenario)
                self._begun.setdefault((runtime, scenario), []).append(future)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self._admission.open()
        self._pool.shutdown(cancel_futures=True)
        self._machine.__exit__()
        self._beside.__exit__()

    def console(self, runtime: str, scenario: Scenario) -> str:
        """The console of one run, with its status in the first line."""
        if begun := self._begun.get((runtime, scenario)):
            return begun.pop().result()
        return self._run(runtime, scenario)

    def _run(self, runtime: str, scenario: Scenario) -> str:
        self._admission.wait()
        begin = time.monotonic()
        status, end, console = self._machine.run(runtime, scenario).partition("\n")
        stalled = self._beside.since(begin)
        told = f"@stall {stalled:.3f}\n" if stalled else ""
        return f"{status}{end}{told}{console}"


def exact(runtime: str, scenario: Scenario) -> list[Outcome]:
    """What a run there may come to: what is recorded, and on the wall what is simulated; there a race is one, too."""
    if runtime != "wall":
        return recorded(scenario)
    usual = simulated(scenario)
    if scenario.name not in expectations.races(f"ros{scenario.ros}"):
        return [usual]
    return [usual, *(_without_abort(outcome, usual.status) for outcome in recorded(scenario))]


def _without_abort(outcome: Outcome, status: int) -> Outcome:
    """The same where no C++ is, which aborts the real process on its way out: it ends with its own status."""
    text = outcome.text.replace("terminate called without an active exception\n", "")
    return outcome if text == outcome.text else outcome._replace(text=text, status=status)


def is_spoilt(runtime: str, scenario: Scenario, console: str) -> bool:
    """Whether a run differs and met a race of the real ROS that any node may meet: it says nothing of the scenario."""
    mishaps = expectations.mishaps("ros2" if runtime == "kilted" else runtime)
    return bool(mishaps.search(console) and closest(exact(runtime, scenario), read(console, scenario)))


def check(runtime: str, scenario: Scenario, console: str) -> None:
    """A run did what it should; one that differs and met a mishap, or was disturbed, tells nothing."""
    if is_spoilt(runtime, scenario, console):
        inconclusive(f"{scenario.name} met a race that any node may meet on {runtime}, see expectations.toml")
    found = closest(exact(runtime, scenario), read(console, scenario))
    if bool(found) != (scenario.name in expectations.differences(runtime)):
        if stalled := read(console, scenario).stalled:
            inconclusive(f"{scenario.name} stood still for {stalled:.3f} s on {runtime}: {found}")
        raise AssertionError("\n".join(found) or "the difference that is expected no longer happens")
