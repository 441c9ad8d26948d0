"""The third verdict: what pytest tells of it, what becomes of it in the quiet lane, and what the control sees."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path
from textwrap import dedent

import pytest
from tree import HELPERS
from verdicts import Control, Inconclusive, control, inconclusive

pytest_plugins = ["pytester"]

# What each test does when it runs for the first time, for the second, and so on; a fresh process goes on counting.
PRELUDE = """
    import os, sys
    from pathlib import Path
    import pytest
    from verdicts import inconclusive

    def act(name, *turns):
        runs = Path("{folder}", name)
        with runs.open("a") as file:
            file.write(f"{{os.getpid()}} {{'xdist' if 'PYTEST_XDIST_WORKER' in os.environ else 'alone'}}\\n")
        turn = turns[len(runs.read_text().splitlines()) - 1]
        if turn == "?":
            inconclusive("a stall of 0.30 s")
        assert turn == ".", "not so"
"""

BOTH_WAYS = pytest.mark.parametrize("options", [[], ["-n", "2", "--dist", "loadfile"]], ids=["alone", "xdist"])


class Session:
    """A session of pytest's, with files of tests that take turns."""

    def __init__(self, pytester: pytest.Pytester) -> None:
        self._pytester = pytester
        pytester.makeini(f"[pytest]\npythonpath = {HELPERS}")
        pytester.makeconftest("pytest_plugins = ['quiet_lane']")

    def write(self, name: str, tests: str) -> None:
        """Write a file of tests."""
        text = dedent(PRELUDE).format(folder=self._pytester.path) + dedent(tests)
        self._pytester.makepyfile(**{name: text})

    def run(self, *options: str) -> pytest.RunResult:
        """Run them all."""
        return self._pytester.runpytest_subprocess("-p", "no:cacheprovider", *options)

    def runs(self, name: str) -> list[list[str]]:
        """In which process a test has run each time, and beside whom."""
        return [line.split() for line in (self._pytester.path / name).read_text().splitlines()]


@pytest.fixture
def session(pytester: pytest.Pytester) -> Session:
    return Session(pytester)


# --- what is told -----------------------------------------------------------------------------------------------------


@BOTH_WAYS
def test_an_inconclusive_test_passes_in_the_quiet_lane_and_that_is_told(session: Session, options: list[str]) -> None:
    session.write("test_a", "def test_a(): act('a', '?', '.')\ndef test_b(): act('b', '.')")
    session.write("test_c", "def test_c(): act('c', '.')")
    told = session.run(*options)
    assert told.ret == 0
    told.stdout.fnmatch_lines(["*?*", "*quiet lane: once more, alone: 1 inconclusive*"])
    told.stdout.fnmatch_lines(["INCONCLUSIVE, THEN PASSED IN THE QUIET LANE test_a.py::test_a - a stall of 0.30 s"])
    told.stdout.fnmatch_lines(["*2 passed, 1 passed in the quiet lane in*"])
    assert [len(session.runs(name)) for name in "abc"] == [2, 1, 1]


@BOTH_WAYS
@pytest.mark.parametrize(("conclusive", "status"), [([], 0), (["--conclusive"], 1)], ids=["test", "judge"])
def test_what_stays_inconclusive_fails_only_what_is_to_be_conclusive(
    session: Session, options: list[str], conclusive: list[str], status: int
) -> None:
    session.write("test_a", "def test_a(): act('a', '?', '?')\ndef test_b(): act('b', '.')")
    told = session.run(*options, *conclusive)
    assert told.ret == status
    told.stdout.fnmatch_lines(["INCONCLUSIVE test_a.py::test_a - a stall of 0.30 s", "*1 passed, 1 inconclusive in*"])
    assert len(session.runs("a")) == 2


@BOTH_WAYS
def test_a_not_so_in_the_quiet_lane_is_a_failure(session: Session, options: list[str]) -> None:
    session.write("test_a", "def test_a(): act('a', '?', 'F', '.')")
    told = session.run(*options)
    assert told.ret == 1
    told.stdout.fnmatch_lines(["*AssertionError: not so*", "The first time it was inconclusive: a stall of 0.30 s"])
    told.stdout.fnmatch_lines(["INCONCLUSIVE, THEN FAILED IN THE QUIET LANE test_a.py::test_a - a stall of 0.30 s"])
    told.stdout.fnmatch_lines(["FAILED test_a.py::test_a - AssertionError: not so", "*1 failed in*"])
    assert len(session.runs("a")) == 2


@BOTH_WAYS
def test_a_not_so_is_never_tried_again(session: Session, options: list[str]) -> None:
    session.write("test_a", "def test_a(): act('a', 'F', '.')\ndef test_b(): act('b', '?', '.')")
    told = session.run(*options)
    assert told.ret == 1
    told.stdout.fnmatch_lines(["*1 failed, 1 passed in the quiet lane in*"])
    assert (len(session.runs("a")), len(session.runs("b"))) == (1, 2)


def test_without_an_inconclusive_test_there_is_no_quiet_lane(session: Session) -> None:
    session.write("test_a", "def test_a(): act('a', '.')")
    told = session.run("--conclusive")
    assert told.ret == 0
    told.stdout.no_fnmatch_line("*quiet lane*")
    told.stdout.no_fnmatch_line("*inconclusive*")


def test_with_verbose_names(session: Session) -> None:
    session.write("test_a", "def test_a(): act('a', '?', '.')")
    told = session.run("-v").stdout
    told.fnmatch_lines(["test_a.py::test_a INCONCLUSIVE*", "test_a.py::test_a INCONCLUSIVE, THEN PASSED IN THE*"])


@pytest.mark.parametrize(
    "fixture", ["act('a', '?', '.')\n    yield", "yield\n    act('a', '?', '.')"], ids=["setup", "teardown"]
)
def test_a_fixture_may_be_inconclusive(session: Session, fixture: str) -> None:
    session.write("test_a", f"@pytest.fixture\ndef f():\n    {fixture}\ndef test_a(f): act('b', '.', '.')\n")
    told = session.run()
    assert told.ret == 0
    told.stdout.fnmatch_lines(["INCONCLUSIVE, THEN PASSED IN THE QUIET LANE test_a.py::test_a - a stall of 0.30 s"])


def test_a_quiet_lane_that_breaks_off_fails_the_session(session: Session) -> None:
    session.write("test_a", "def test_a():\n    if Path('a').exists(): os._exit(5)\n    act('a', '?')")
    told = session.run()
    assert told.ret == 3
    told.stdout.fnmatch_lines(["*the quiet lane broke off with status 5:*"])


# --- the lane is quiet ------------------------------------------------------------------------------------------------


def test_the_quiet_lane_is_one_process_after_the_workers_have_ended(session: Session) -> None:
    session.write("test_a", "def test_a(): act('a', '?', '.')\n")
    session.write(
        "test_b",
        """
        def test_b():
            act("b", "?", ".")
            pids = {line.split()[0] for name in "ab" for line in Path(name).read_text().splitlines()}
            assert {pid for pid in pids if Path("/proc", pid).exists()} == {str(os.getpid())}
        """,
    )
    told = session.run("-n", "2", "--dist", "loadfile")
    assert told.ret == 0, told.stdout.str()
    told.stdout.fnmatch_lines(["*2 passed in the quiet lane in*"])
    (_, beside_a), (alone_a, quiet_a) = session.runs("a")
    (_, beside_b), (alone_b, quiet_b) = session.runs("b")
    assert (beside_a, beside_b, quiet_a, quiet_b) == ("xdist", "xdist", "alone", "alone")
    assert alone_a == alone_b


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
            assert 2 == 3, "two are three"
    with pytest.raises(AssertionError, match="two are three"):
        with control(bears=1e9):
            assert 2 == 3, "two are three"


def test_another_error_is_one_whatever_the_machine_does() -> None:
    with pytest.raises(ZeroDivisionError):
        with control(bears=-1):
            1 / 0


@pytest.mark.parametrize(
    ("calls", "stalled"),
    [
        ([(0.025, 0.0)] * 9, 0),  # on time, and nobody waits
        ([(0.026, 0.001)] * 9, 0),  # what always is
        ([(0.025, 0.0), (0.3, 0.0), (0.025, 0.0)], 0.3),  # called late itself
        ([(0.025, 0.025)] * 4, 0.1),  # somebody waits all the time
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
    code = "from verdicts import Control\nwith Control() as beside: print(); input()\nprint(beside.stalled())"
    command = [sys.executable, "-u", "-c", code]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, cwd=HELPERS, stdin=pipe, stdout=pipe, text=True) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(signal.SIGSTOP)
        while Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()[0] != "T":
            pass
        time.sleep(0.2)
        process.send_signal(signal.SIGCONT)
        out, _ = process.communicate("\n")
    assert float(out) >= 0.2
