"""Nodes that never let time pass are ended by a watchdog, which counts the time for which they really work."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from textwrap import dedent
from time import perf_counter
from typing import Any

import pytest

import rosspin
from rosspin import TimeStandsStill, rospy, simulate
from rosspin.clocks import simulation, watchdog
from rosspin.exercises import check
from tests.helpers.endless import CHILDREN, OBSTINATE, SLEEPING, SOME, as_before, noting, source

pytestmark = pytest.mark.shares(10)


@pytest.fixture
def raised(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[bool]]:
    with noting(monkeypatch) as found:
        yield found


@pytest.fixture
def watched(monkeypatch: pytest.MonkeyPatch) -> None:
    """The threads are as many as it takes until the watchdog comes."""
    monkeypatch.setattr(simulation, "MOST_STACKS", 10**9)
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.05)


@pytest.mark.parametrize("text", [source(ros, body) for ros in (1, 2) for body in (SLEEPING, CHILDREN, OBSTINATE)])
def test_so_does_the_watchdog_and_nothing_is_raised_in_what_is_ending(
    text: str, write: Any, watched: None, raised: list[bool]
) -> None:
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still"):
        simulate(write(text), 5)
    assert not any(raised)
    assert as_before()


def test_a_look_holds_no_frame(watched: None, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a frame refers to would be there until the next look."""
    looks: list[float] = []
    look = watchdog._FromAThread._look

    def counted(self: Any) -> float:
        looks.append(look(self))
        return looks[-1]

    def node() -> None:
        while len(looks) < 4:
            pass

    asked: list[str] = []

    def current_frames() -> dict[int, Any]:
        asked.append("for frames")
        return {}

    monkeypatch.setattr(watchdog._FromAThread, "_look", counted)
    monkeypatch.setattr(sys, "_current_frames", current_frames)
    simulate(node, 1.0)
    assert (len(looks) >= 4, asked) == (True, [])


@pytest.mark.parametrize("text", [source(ros, body) for ros in (1, 2) for body in (SLEEPING, OBSTINATE)])
def test_the_place_is_known_even_if_none_of_its_lines_was_running(
    text: str, write: Any, watched: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "_current_frames", lambda: {})
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still"):
        simulate(write(text), 5)


def test_in_another_thread_the_watchdog_takes_back_what_it_has_not_raised(
    write: Any, watched: None, raised: list[bool]
) -> None:
    errors: list[BaseException] = []

    def run() -> None:
        try:
            simulate(write(source(1, CHILDREN)), 5)
        except TimeStandsStill as error:
            errors.append(error)
        sum(range(100_000))  # what was still to be raised would be here

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert len(errors) == 1 and not any(raised) and as_before()


@pytest.mark.parametrize("text", SOME)
def test_on_the_command_line_a_line_is_printed_and_no_more(text: str, write: Any) -> None:
    words = [sys.executable, "-m", "rosspin", "run", "--simulated", "--seconds", "5", str(write(text))]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.count("\n") == 1 and "simulated time stands still at 0.0 s" in done.stderr


def test_what_refuses_to_end_is_given_up_and_the_result_stands(
    monkeypatch: pytest.MonkeyPatch, raised: list[bool]
) -> None:
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.05)
    ends: list[int] = []

    def work(number: int) -> None:
        try:
            rospy.sleep(1)
        finally:
            while True:
                ends.append(number)

    def main() -> None:
        rospy.init_node("node")
        for number in range(5):
            threading.Thread(target=work, args=(number,), daemon=True).start()
        rospy.sleep(0.5)
        print("done")

    done = simulate(main, 5)
    assert (done.status, done.console) == (0, "done\n")
    assert set(ends) == {0}, "the time of all is over with the first's"
    assert any(raised) and as_before()


C_CODE = {
    "a power": "9**9**9",
    "a regular expression": "re.match('(a+)+$', 'a' * 60 + 'b')",
    "a loop that gives way to no thread": "(sys.setswitchinterval(1e6), [0 for _ in itertools.count()])",
}


@pytest.mark.parametrize("how", ["main", "thread", "end"])
@pytest.mark.parametrize("name", C_CODE)
def test_code_in_c_that_lets_no_thread_run(name: str, how: str, write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """It ends the watchdog's way, which gives it more time; and so it does while a run is taken down."""
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.005)
    before = signal.getsignal(signal.SIGVTALRM), signal.getitimer(signal.ITIMER_VIRTUAL)
    body = {
        "main": f"{C_CODE[name]}",
        "thread": f"threading.Thread(target=lambda: {C_CODE[name]}).start()",
        "end": f"""
            def work():
                try:
                    SLEEP(1)
                finally:
                    {C_CODE[name]}

            threading.Thread(target=work, daemon=True).start()
            SLEEP(0.5)
            """,
    }[how]
    path = str(write("import itertools, re, sys\n" + source(1, body)))
    if how == "end":
        assert simulate(path, 5).status == 0
    else:
        with pytest.raises(TimeStandsStill, match=r"node\.py:5: .*: simulated time .* has computed for \d+ s"):
            simulate(path, 5)
    assert before == (signal.getsignal(signal.SIGVTALRM), signal.getitimer(signal.ITIMER_VIRTUAL))
    assert as_before()


def test_so_it_ends_in_a_test_and_in_an_exercise(write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.005)
    text = source(1, "SLEEP(1)\n9**9**9")
    with pytest.raises(TimeStandsStill, match=r"at 1\.0 s, because this has computed"):
        with rosspin.start(write(text)) as started:
            started.advance(2)
    assert "because this has computed" in str(check("ten-hertz", text))


@pytest.mark.parametrize("launched", [False, True])
def test_on_the_command_line_even_if_it_heeds_no_signal(launched: bool, write: Any, tmp_path: Path) -> None:
    path = str(write("import itertools\n" + source(1, "SLEEP(1)\nsum(itertools.count())")))
    if launched:
        (tmp_path / "package.xml").write_text("<package><name>pkg</name></package>")
        (tmp_path / "a.launch").write_text("<launch><node pkg='pkg' type='node.py' name='node'/></launch>")
    file = str(tmp_path / "a.launch") if launched else path
    program = f"""
        import sys
        from rosspin.__main__ import main
        from rosspin.clocks import guard
        guard._SILENT = 2.0
        sys.argv = ["rosspin", "run", "--simulated", "--seconds", "5", {file!r}]
        main()
    """
    done = subprocess.run([sys.executable, "-c", dedent(program)], capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stdout) == (-signal.SIGKILL, "")
    assert done.stderr == (
        f"rosspin: {path}:6: this has let nothing else run for a minute, and heeds no signal; the process was killed\n"
    )


def test_if_nothing_else_ends_it_the_process_ends_and_says_why(write: Any, tmp_path: Path) -> None:
    body = """
        import ctypes

        def work():
            mutex = ctypes.create_string_buffer(256)
            lock = ctypes.CDLL(None).pthread_mutex_lock
            try:
                SLEEP(1)
            finally:
                lock(mutex)
                lock(mutex)

        threading.Thread(target=work, daemon=True).start()
        SLEEP(0.5)
    """
    path = str(write(source(1, body)))
    program = f"""
        import rosspin
        from rosspin.clocks import watchdog
        watchdog._INTERVAL = 0.01
        rosspin.simulate({path!r}, 5)
    """
    done = subprocess.run([sys.executable, "-c", dedent(program)], capture_output=True, text=True, timeout=300)
    assert done.returncode == 1
    assert done.stderr.startswith(f"rosspin: {path}:") and done.stderr.count("\n") == 1


def test_a_node_that_works_is_not_said_to_wait_because_the_machine_is_busy(
    impatient: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The kernel says that it has a processor for a tenth of the time, and stands in line for one in the rest."""

    def node() -> None:
        while True:
            pass

    share = 0.1
    assert share < watchdog._BUSY
    begun = perf_counter()

    def scheduled(watcher: object) -> tuple[float, float]:
        passed = perf_counter() - begun
        return share * passed, (1 - share) * passed

    monkeypatch.setattr(watchdog._FromAThread, "_scheduled_until_now", scheduled)
    with pytest.raises(TimeStandsStill, match="keeps running without sleeping"):
        simulate(node, 1)
    # As many looks as ever at its own time, which is a tenth of what has passed.
    assert share * (perf_counter() - begun) > 0.8 * watchdog._LOOKS * watchdog._INTERVAL
