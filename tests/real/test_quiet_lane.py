"""The third verdict: what pytest tells of it, what becomes of it in the quiet lane, and what the control sees."""

from __future__ import annotations

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


class Session:
    """A session of pytest's, with files of tests that take turns."""

    def __init__(self, pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> None:
        self._pytester = pytester
        monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")  # it starts in half the time
        monkeypatch.setenv("PYTEST_ADDOPTS", "-p xdist")
        monkeypatch.delenv("PYTEST_XDIST_WORKER", raising=False)  # of the session that this is a test of
        pytester.makeini(f'[pytest]\npythonpath = "{HELPERS}"')
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
def session(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> Session:
    return Session(pytester, monkeypatch)


# --- what is told, and how it ends ------------------------------------------------------------------------------------


@pytest.mark.parametrize("options", [[], ["-n", "2", "--dist", "loadfile"]], ids=["alone", "xdist"])
def test_an_inconclusive_test_runs_once_more_alone_and_what_comes_of_it_is_told(
    session: Session, options: list[str]
) -> None:
    session.write("test_a", "def test_a(): act('a', '?', '.', '.')\ndef test_b(): act('b', '?', 'F', '.')")
    session.write(
        "test_c",
        """
        def test_c(): act("c", "?", "?", ".")
        def test_d(): act("d", "F", ".")
        def test_e(): act("e", ".")
        def test_f():
            act("f", "?", ".")
            pids = {line.split()[0] for name in "abcdef" for line in Path(name).read_text().splitlines()}
            there = {int(pid) for pid in pids if Path("/proc", pid).exists()}
            assert there <= {os.getpid(), os.getppid()}, "somebody is beside it"
        """,
    )
    told = session.run(*options)
    assert told.ret == 1
    lines = told.stdout
    for line in (
        "*quiet lane: once more, alone: 4 inconclusive*",
        "*AssertionError: not so*",
        "The first time it was inconclusive: a stall of 0.30 s",
        "INCONCLUSIVE, THEN PASSED IN THE QUIET LANE test_a.py::test_a - a stall of 0.30 s",
        "INCONCLUSIVE, THEN FAILED IN THE QUIET LANE test_a.py::test_b - a stall of 0.30 s",
        "INCONCLUSIVE test_c.py::test_c - a stall of 0.30 s",
        "INCONCLUSIVE, THEN PASSED IN THE QUIET LANE test_c.py::test_f - a stall of 0.30 s",
        "FAILED test_a.py::test_b - AssertionError: not so",
        "FAILED test_c.py::test_d - AssertionError: not so",
        "=* 2 failed, 1 passed,*",
        "=*, 2 passed in the quiet lane*",
        "=*, 1 inconclusive*",
    ):
        lines.fnmatch_lines([line])
    runs = {name: session.runs(name) for name in "abcdef"}
    assert {name: len(runs[name]) for name in runs} == {"a": 2, "b": 2, "c": 2, "d": 1, "e": 1, "f": 2}
    assert {how for _, how in (run[0] for run in runs.values())} == {"xdist" if options else "alone"}
    assert {how for name in "abcf" for _, how in runs[name][1:]} == {"alone"}
    assert len({process for name in "abcf" for process, _ in runs[name][1:]}) == 1


@pytest.mark.parametrize(
    ("turns", "options", "status"),
    [("??", [], 0), ("??", ["--conclusive"], 1), ("?.", ["--conclusive"], 0)],
)
def test_the_exit_status(session: Session, turns: str, options: list[str], status: int) -> None:
    session.write("test_a", f"def test_a(): act('a', *{turns!r})\ndef test_b(): act('b', '.')")
    assert session.run(*options).ret == status


def test_without_an_inconclusive_test_there_is_no_quiet_lane(session: Session) -> None:
    session.write("test_a", "def test_a(): act('a', '.')")
    told = session.run("--conclusive")
    assert told.ret == 0
    told.stdout.no_fnmatch_line("*quiet lane:*")


def test_in_words(session: Session) -> None:
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
