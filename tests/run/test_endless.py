"""Nodes that start thread after thread: their run ends, with a clear error, and costs no more than it has to."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from textwrap import dedent
from types import FunctionType
from typing import Any

import pytest

import rosspin
from rosspin import TimeStandsStill, rospy, simulate
from rosspin.clocks import simulation, watchdog
from rosspin.clocks.ending import Ended
from rosspin.clocks.stacks import current
from rosspin.exercises import check
from rosspin.run import simulate as run

_SLEEPING = """
    def work():
        SLEEP(1)

    while True:
        threading.Thread(target=work).start()
"""
_DAEMONS = """
    while True:
        threading.Thread(target=SLEEP, args=(1,), daemon=True).start()
"""
_CHILDREN = """
    def work():
        threading.Thread(target=work).start()
        threading.Thread(target=work).start()
        SLEEP(0.1)

    work()
"""
_UNASKED = """
    while True:
        _thread.start_new_thread(SLEEP, (1,))
        SLEEP(0.0001)
"""
_POOLS = """
    def work():
        concurrent.futures.ThreadPoolExecutor(1).submit(work)
        SLEEP(1)

    work()
"""
_LAST_WILL = """
    def work():
        try:
            SLEEP(1)
        finally:
            while True:
                threading.Thread(target=work).start()

    while True:
        threading.Thread(target=work).start()
"""
_TIMERS = """
    def callback(event):
        rospy.Timer(rospy.Duration(0.01), callback)
        rospy.Timer(rospy.Duration(0.01), callback)

    callback(None)
    rospy.spin()
"""
_RATES = """
    node = rclpy.create_node("node")
    while True:
        threading.Thread(target=node.create_rate(10).sleep, daemon=True).start()
"""
_OBSTINATE = """
    def work():
        while True:
            try:
                SLEEP(1)
            except BaseException:
                pass

    while True:
        threading.Thread(target=work, daemon=True).start()
"""

_BOTH = {
    "sleeping": _SLEEPING,
    "daemons": _DAEMONS,
    "children": _CHILDREN,
    "without Thread": _UNASKED,
    "pools": _POOLS,
    "last will": _LAST_WILL,
    "obstinate": _OBSTINATE,
}


def source(ros: int, body: str) -> str:
    begin = {1: "import rospy\nrospy.init_node('node')", 2: "import rclpy, time\nrclpy.init()"}[ros]
    body = dedent(body).replace("SLEEP", {1: "rospy.sleep", 2: "time.sleep"}[ros])
    return f"import _thread, concurrent.futures, threading\n{begin}\n{body}"


NODES = [
    *(pytest.param(source(ros, body), id=f"ros{ros} {name}") for name, body in _BOTH.items() for ros in (1, 2)),
    pytest.param(source(1, _TIMERS), id="ros1 timers"),
    pytest.param(source(2, _RATES), id="ros2 rates"),
]
SOME = [pytest.param(source(ros, _SLEEPING), id=f"ros{ros}") for ros in (1, 2)]


@pytest.fixture
def node(tmp_path: Path) -> Callable[[str], str]:
    def write(text: str) -> str:
        path = tmp_path / "node.py"
        path.write_text(text)
        return str(path)

    return write


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation, "MOST_STACKS", 100)


@pytest.fixture
def watched(monkeypatch: pytest.MonkeyPatch) -> None:
    """The threads are as many as it takes until the watchdog comes."""
    monkeypatch.setattr(simulation, "MOST_STACKS", 10**9)
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.05)


@pytest.fixture
def raised(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[bool]]:
    """For each Ended, whether a run was being taken down when it was raised; none is raised unheard."""
    found: list[bool] = []
    unheard: list[Any] = []
    taken_down = False
    init, begin = Ended.__init__, watchdog.Watchdog._begin

    def noting(self: Ended) -> None:
        found.append(taken_down)
        init(self)

    def beginning(self: watchdog.Watchdog, taking_down: bool) -> None:
        nonlocal taken_down
        begin(self, taking_down)
        taken_down = taking_down

    # As a function of rosspin, in which nothing is raised.
    ours = FunctionType(noting.__code__, {"__name__": "rosspin"}, closure=noting.__closure__)
    monkeypatch.setattr(Ended, "__init__", ours)
    monkeypatch.setattr(watchdog.Watchdog, "_begin", beginning)
    monkeypatch.setattr(sys, "unraisablehook", unheard.append)
    yield found
    assert not unheard


def as_before() -> bool:
    """Whether a run is as always, and nothing of an earlier one is in the way."""

    def node() -> None:
        threads = [threading.Thread(target=print, args=(number,)) for number in range(3)]
        for thread in threads:
            thread.start()

    return simulate(node, 1).console == "0\n1\n2\n" and sys.gettrace() is None


@pytest.mark.parametrize("text", NODES)
def test_too_many_threads_end_the_run(text: str, node: Any, few: None, raised: list[bool]) -> None:
    trace = sys.gettrace()
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still at .*100 threads have not"):
        simulate(node(text), 5)
    assert not any(raised)
    assert sys.gettrace() is trace and as_before()


@pytest.mark.parametrize("text", [source(ros, body) for ros in (1, 2) for body in (_SLEEPING, _CHILDREN, _OBSTINATE)])
def test_so_does_the_watchdog_and_nothing_is_raised_in_what_is_ending(
    text: str, node: Any, watched: None, raised: list[bool]
) -> None:
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still"):
        simulate(node(text), 5)
    assert not any(raised)
    assert as_before()


@pytest.mark.parametrize("text", [source(ros, body) for ros in (1, 2) for body in (_SLEEPING, _OBSTINATE)])
def test_the_place_is_known_even_if_none_of_its_lines_was_running(
    text: str, node: Any, watched: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "_current_frames", lambda: {})
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: simulated time stands still"):
        simulate(node(text), 5)


@pytest.mark.parametrize("thread", ["", "threading.Thread(target=SLEEP, args=(5,)).start()"])
def test_so_it_is_if_time_stands_still_between_two_stacks(
    thread: str, node: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Standing(simulation.Simulation):
        def _next(self) -> Any:
            if current() is self._home and self.now():
                raise simulation.Standstill([], "")
            return super()._next()

    monkeypatch.setattr(run, "Simulation", Standing)
    text = source(1, f"{thread}\nrospy.sleep(1)\nthreading.Thread(target=rospy.sleep, args=(1,)).start()\nrospy.spin()")
    line = text.count("\n")
    with pytest.raises(TimeStandsStill, match=rf"node\.py:{line}: simulated time stands still"):
        simulate(node(text), 5)


@pytest.mark.parametrize("text", SOME)
def test_in_a_test_in_an_exercise_and_in_another_thread(text: str, node: Any, few: None) -> None:
    path = node(text)
    with pytest.raises(TimeStandsStill), rosspin.start(path) as started:
        started.advance(1)
    assert "simulated time stands still" in str(check("ten-hertz" if "rospy" in text else "call-back-once", text))
    errors: list[BaseException] = []

    def run() -> None:
        try:
            simulate(path, 5)
        except TimeStandsStill as error:
            errors.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert len(errors) == 1 and as_before()


def test_in_another_thread_the_watchdog_takes_back_what_it_has_not_raised(
    node: Any, watched: None, raised: list[bool]
) -> None:
    errors: list[BaseException] = []

    def run() -> None:
        try:
            simulate(node(source(1, _CHILDREN)), 5)
        except TimeStandsStill as error:
            errors.append(error)
        sum(range(100_000))  # what was still to be raised would be here

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert len(errors) == 1 and not any(raised) and as_before()


def test_among_several_nodes(node: Any, few: None, tmp_path: Path) -> None:
    quiet = tmp_path / "quiet.py"
    quiet.write_text("import rospy\nrospy.init_node('quiet')\nrospy.spin()\n")
    with pytest.raises(TimeStandsStill, match=r"node\.py:\d+: .*100 threads"):
        simulate([str(quiet), node(source(1, _SLEEPING))], 5)
    assert as_before()


@pytest.mark.parametrize("text", SOME)
def test_on_the_command_line_a_line_is_printed_and_no_more(text: str, node: Any) -> None:
    words = [sys.executable, "-m", "rosspin", "run", "--simulated", "--seconds", "5", node(text)]
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
def test_code_in_c_that_lets_no_thread_run(name: str, how: str, node: Any, monkeypatch: pytest.MonkeyPatch) -> None:
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
    path = node("import itertools, re, sys\n" + source(1, body))
    if how == "end":
        assert simulate(path, 5).status == 0
    else:
        with pytest.raises(TimeStandsStill, match=r"node\.py:5: .*: simulated time .* has computed for \d+ s"):
            simulate(path, 5)
    assert before == (signal.getsignal(signal.SIGVTALRM), signal.getitimer(signal.ITIMER_VIRTUAL))
    assert as_before()


def test_so_it_ends_in_a_test_and_in_an_exercise(node: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watchdog, "_INTERVAL", 0.005)
    text = source(1, "SLEEP(1)\n9**9**9")
    with pytest.raises(TimeStandsStill, match=r"at 1\.0 s, because this has computed"):
        with rosspin.start(node(text)) as started:
            started.advance(2)
    assert "because this has computed" in str(check("ten-hertz", text))


@pytest.mark.parametrize("launched", [False, True])
def test_on_the_command_line_even_if_it_heeds_no_signal(launched: bool, node: Any, tmp_path: Path) -> None:
    path = node("import itertools\n" + source(1, "SLEEP(1)\nsum(itertools.count())"))
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


def test_if_nothing_else_ends_it_the_process_ends_and_says_why(node: Any, tmp_path: Path) -> None:
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
    path = node(source(1, body))
    program = f"""
        import rosspin
        from rosspin.clocks import watchdog
        watchdog._INTERVAL = 0.01
        rosspin.simulate({path!r}, 5)
    """
    done = subprocess.run([sys.executable, "-c", dedent(program)], capture_output=True, text=True, timeout=300)
    assert done.returncode == 1
    assert done.stderr.startswith(f"rosspin: {path}:") and done.stderr.count("\n") == 1
