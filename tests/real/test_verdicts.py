"""The third verdict: what becomes of a test that the machine disturbed, and what the control next to a run sees."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.helpers.launches import NEVER
from tests.helpers.tree import ROOT, TESTS
from tests.helpers.verdicts import Control, Inconclusive, control, inconclusive

pytest_plugins = ["pytester"]

# What a test does when it runs for the first time, for the second, and so on.
TURNS = """
import pytest
from tests.helpers.verdicts import inconclusive

RUNS = {}

def act(name, turns):
    RUNS[name] = RUNS.get(name, 0) + 1
    turn = turns[RUNS[name] - 1]
    if turn == "?":
        inconclusive("a stall of 0.30 s")
    assert turn == ".", f"not so in run {RUNS[name]}"

"""
CASES = """
def test_once(): act("a", "?.")
def test_twice(): act("b", "??.")
def test_never(): act("c", "???")
def test_then_fails(): act("d", "?F.")
def test_fails(): act("e", "F.")

@pytest.fixture
def before(): act("f", "?.")
@pytest.fixture
def after():
    yield
    act("g", "?.")
def test_before(before): pass
def test_after(after): pass
"""


# --- what becomes of a test -------------------------------------------------------------------------------------------


@pytest.fixture
def session(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> Callable[..., pytest.RunResult]:
    """Runs tests of the real lane; the result."""
    monkeypatch.delenv("PYTEST_XDIST_WORKER", raising=False)  # of the session that this is a test of
    pytester.makeini(f'[pytest]\npythonpath = "{ROOT}"')
    pytester.makeconftest((TESTS / "real" / "conftest.py").read_text(encoding="utf-8"))
    plugins = ["-p", "pytest_rerunfailures", "-p", "xdist.plugin", "-p", "no:cacheprovider"]

    def run(tests: str, *options: str) -> pytest.RunResult:
        pytester.makepyfile(test_of_it=TURNS + tests)
        return pytester.runpytest_subprocess("--disable-plugin-autoload", *plugins, "-ra", *options)

    return run


@pytest.mark.parametrize("options", [[], ["-n", "1"]], ids=["alone", "xdist"])
def test_an_inconclusive_test_runs_again_and_is_skipped_if_it_stays_so(
    session: Callable[..., pytest.RunResult], options: list[str]
) -> None:
    told = session(CASES, *options)
    assert told.ret == 1
    told.assert_outcomes(passed=5, failed=2, skipped=1)
    told.stdout.fnmatch_lines(["SKIPPED * inconclusive: a stall of 0.30 s"])
    told.stdout.fnmatch_lines(["FAILED *::test_then_fails - AssertionError: not so in run 2"])
    told.stdout.fnmatch_lines(["FAILED *::test_fails - AssertionError: not so in run 1"])


@pytest.mark.parametrize(
    ("turns", "options", "status"),
    [("???", [], 0), ("???", ["--conclusive"], 1), ("??.", ["--conclusive"], 0)],
)
def test_the_exit_status(session: Callable[..., pytest.RunResult], turns: str, options: list[str], status: int) -> None:
    assert session(f"def test_a(): act('a', {turns!r})", *options).ret == status


# --- the control ------------------------------------------------------------------------------------------------------


def test_no_handler_takes_it_for_an_error() -> None:
    with pytest.raises(Inconclusive, match="a stall"):
        try:
            inconclusive("a stall")
        except Exception:
            pytest.fail("it was taken for an error")


def test_what_holds_is_conclusive_whatever_the_machine_does() -> None:
    with control(bears=-1):
        assert True


def test_a_not_so_is_inconclusive_only_if_the_machine_has_stalled_for_longer_than_the_test_bears() -> None:
    with pytest.raises(Inconclusive, match=r"the machine stalled for .* s \(the test bears -1 s\): two are three"):
        with control(bears=-1):
            assert not "two", "two are three"
    with pytest.raises(AssertionError, match="two are three"):
        with control(bears=1e9):
            assert not "two", "two are three"


def test_another_error_is_one_whatever_the_machine_does() -> None:
    with pytest.raises(ZeroDivisionError):
        with control(bears=-1):
            1 / 0


@pytest.mark.parametrize(
    ("calls", "stalled"),
    [
        ([(0.025, 0.0)] * 9, 0),  # on time, and nothing waits
        ([(0.026, 0.001)] * 9, 0),  # what always is
        ([(0.025, 0.0), (0.3, 0.0), (0.025, 0.0)], 0.3),  # called late itself
        ([(0.025, 0.025)] * 4, 0.1),  # something waits all the time
        ([(0.025, 0.025), (0.025, 0.0)] * 4, 0.025),  # only now and then
        ([(0.025, 0.025), (0.05, 0.0), (0.025, 0.0)], 0.075),  # first the one, then the other
    ],
)
def test_a_stall_is_a_stretch_in_which_somebody_always_waits(calls: list[tuple[float, float]], stalled: float) -> None:
    beside = Control()
    for took, waited in calls:
        beside.called(took, waited)
    assert beside.stalled() == pytest.approx(stalled)


def test_a_line_at_one_processor_of_several_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Control, "SHARE", 0.5 / 4)
    beside = Control()
    beside.called(0.025, 0.025 / 4)
    assert beside.stalled() == 0.025


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells that a process has been stopped")
def test_a_process_that_stands_still_is_noticed() -> None:
    code = "from tests.helpers.verdicts import Control\n"
    code += "with Control() as beside: print(flush=True); input()\nprint(beside.stalled())"
    command = [sys.executable, "-c", code]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, cwd=ROOT, stdin=pipe, stdout=pipe, text=True) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(signal.SIGSTOP)
        while Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0] != "T":
            pass
        time.sleep(0.2)
        process.send_signal(signal.SIGCONT)
        out, _ = process.communicate("\n")
    assert float(out) >= 0.2


@pytest.mark.skipif(not Path("/proc/pressure/cpu").exists(), reason="this kernel does not count who waits")
def test_those_who_wait_for_a_processor_are_noticed() -> None:
    others = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(3 * (os.cpu_count() or 1))]
    try:
        with Control() as beside:
            begun = time.monotonic()
            while beside.stalled() < 0.2 and time.monotonic() < begun + NEVER:
                time.sleep(0.05)
    finally:
        for other in others:
            other.kill()
            other.wait()
    assert beside.stalled() >= 0.2
