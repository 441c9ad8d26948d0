"""A node's own threads, locks, signals and clocks: what simulated time makes of them, and what it leaves alone."""

from __future__ import annotations

import _thread
import os
import queue
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from rosspin import TimeStandsStill, measure, rospy, simulate
from rosspin.clocks import watchdog

# Only so that a test that hangs ends at all.
NEVER = 60


# --- simulated time ---------------------------------------------------------------------------------------------------


def test_a_lock_keeps_two_callbacks_apart() -> None:
    def node() -> None:
        rospy.init_node("node")
        lock = threading.Lock()

        def work(event: object) -> None:
            with lock:
                print("in", rospy.get_time())
                rospy.sleep(0.3)
                print("out", rospy.get_time())

        for _ in range(2):
            rospy.Timer(rospy.Duration(1), work, oneshot=True)
        rospy.sleep(2)

    assert simulate(node, 5).console.split() == ["in", "1.0", "out", "1.3", "in", "1.3", "out", "1.6"]


def test_waits_with_a_timeout_end_exactly_then() -> None:
    ended: list[float] = []

    def node() -> None:
        threading.Event().wait(0.1)
        ended.append(time.monotonic())
        with pytest.raises(queue.Empty):
            queue.Queue[int]().get(timeout=0.2)
        ended.append(time.monotonic())
        with condition:
            condition.wait_for(lambda: False, 0.4)
        ended.append(time.monotonic())
        threading.Semaphore(0).acquire(timeout=0.8)
        ended.append(time.monotonic())

    condition = threading.Condition()
    assert simulate(node, 20).status == 0
    assert ended == [0.1, 0.3, 0.7, 1.5]


def after(seconds: float, word: str) -> None:
    time.sleep(seconds)
    print(word)


def test_a_pool_and_the_threads_that_are_no_daemons_are_waited_for() -> None:
    def node() -> None:
        ThreadPoolExecutor(1).submit(after, 2, "pool")
        threading.Thread(target=after, args=(3, "thread")).start()
        threading.Thread(target=after, args=(4, "daemon"), daemon=True).start()
        print("main")

    run = simulate(node, 10)
    assert (run.status, run.console) == (0, "main\npool\nthread\n")


def test_names_and_idents_begin_anew_in_each_run() -> None:
    def node() -> None:
        threads = [threading.Thread(target=time.sleep, args=(1,)) for _ in range(2)]
        for thread in threads:
            thread.start()
        with ThreadPoolExecutor(1) as pool:
            print(pool.submit(lambda: threading.current_thread().name).result())
        print(*(thread.name for thread in threading.enumerate()), [thread.ident for thread in threads])

    assert simulate(node, 5) == simulate(node, 5)
    assert simulate(node, 5).console.startswith("ThreadPoolExecutor-0_0\nMainThread Thread-1 (sleep) Thread-2 (sleep)")


def test_a_node_that_hangs_is_killed_and_the_console_says_where_its_threads_were(write: Any) -> None:
    path = write(
        """
        import threading

        lock = threading.Lock()
        lock.acquire()

        def stuck():
            lock.acquire()

        thread = threading.Thread(target=stuck, name="reader")
        thread.start()
        try:
            thread.join()
        except KeyboardInterrupt:
            lock.acquire()
        """
    )
    run = simulate(path, 1)
    assert run.status == 137
    *why, first, main, reader = run.console.splitlines()
    assert why[1] == "rosspin:   the thread MainThread waits for the end of the thread reader"
    assert first.startswith("rosspin: Ctrl-C at 1 s did not end the node; it was killed 17 s later, as roslaunch does.")
    assert [main, reader] == [
        f"rosspin: MainThread was at {path}:15: lock.acquire()",
        f"rosspin: reader was at {path}:8: lock.acquire()",
    ]


def test_what_a_killed_node_leaves_is_none_of_the_next_run_s() -> None:
    def hangs() -> None:
        rospy.init_node("hangs")  # its handler raises no KeyboardInterrupt
        ThreadPoolExecutor(1).submit(threading.Event().wait)
        threading.Thread(target=threading.Event().wait).start()

    before = set(threading.enumerate())
    assert simulate(hangs, 1).status == 137
    assert set(threading.enumerate()) == before
    assert simulate(lambda: ThreadPoolExecutor(1).submit(print, "done").result() or None, 1).console == "done\n"


def test_other_threads_of_the_process_are_left_alone() -> None:
    asked, answered = threading.Event(), threading.Event()
    kinds: list[Any] = []

    def outside() -> None:
        asked.wait(NEVER)
        kinds.extend([type(threading.Lock()), type(threading.RLock()), threading.get_ident()])
        thread = threading.Thread(target=lambda: kinds.append(time.time()))
        thread.start()
        thread.join()
        answered.set()

    thread = threading.Thread(target=outside)
    thread.start()

    def node() -> None:
        asked.set()
        answered.wait(NEVER)

    simulate(node, 1)
    thread.join()
    assert kinds[:3] == [type(threading.Lock()), type(threading.RLock()), thread.ident]
    assert kinds[3] > 1e9


def test_afterwards_everything_is_as_it_was() -> None:
    places = [(threading, name) for name in ("Lock", "RLock", "local", "get_ident", "enumerate", "excepthook")]
    places += [(_thread, "allocate_lock"), (_thread, "start_new_thread"), (queue, "SimpleQueue"), (signal, "signal")]
    before = [getattr(place, name) for place, name in places]
    simulate(lambda: threading.Thread(target=print).start(), 1)
    assert [getattr(place, name) for place, name in places] == before


def test_a_loop_that_only_looks_gets_on() -> None:
    def node() -> None:
        lock = threading.Lock()
        lock.acquire()
        threading.Timer(0.002, lock.release).start()
        while not lock.acquire(blocking=False):
            pass
        print(time.time() >= 0.002)

    assert simulate(node, 1).console == "True\n"


# --- signals ----------------------------------------------------------------------------------------------------------


def test_ctrl_c_calls_the_node_s_own_handler() -> None:
    def node() -> None:
        def handler(number: int, frame: Any) -> None:
            print("handler", number, time.time(), threading.current_thread().name)

        signal.signal(signal.SIGINT, handler)
        time.sleep(3)  # continues after the handler
        print(time.time(), signal.getsignal(signal.SIGINT) is handler)

    before = signal.getsignal(signal.SIGINT)
    assert simulate(node, 2).console == "handler 2 2.0 MainThread\n3.0 True\n"
    assert signal.getsignal(signal.SIGINT) is before


def test_the_watchdog_does_not_call_it(impatient: None) -> None:
    called: list[int] = []

    def node() -> None:
        signal.signal(signal.SIGINT, lambda number, frame: called.append(number))
        while True:
            pass

    with pytest.raises(TimeStandsStill, match="keeps running without sleeping"):
        simulate(node, 2)
    assert called == []


def test_a_signal_without_a_handler_ends_the_node() -> None:
    assert simulate(lambda: os.kill(os.getpid(), signal.SIGTERM), 1).status == 143


def test_a_real_ctrl_c_ends_a_simulated_run(write: Any) -> None:
    path = write(
        """
        print("busy", flush=True)
        while True:
            try:
                while True:
                    pass
            except BaseException:
                pass
        """
    )
    command = [sys.executable, "-m", "rosspin", "run", str(path), "--simulated", "--seconds", "1"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=NEVER)
    assert (process.returncode, err) == (130, "")


def test_signals_disturb_no_sleep_that_comes_after_them() -> None:
    def node() -> None:
        def send() -> None:
            for _ in range(3):
                time.sleep(0.1)
                os.kill(os.getpid(), signal.SIGUSR1)

        signal.signal(signal.SIGUSR1, lambda number, frame: None)
        threading.Thread(target=send).start()
        for length in (1, 2, 2):
            time.sleep(length)
            print(time.time())

    assert simulate(node, 10).console == "1.0\n3.0\n5.0\n"


def test_a_handler_that_sets_what_its_own_thread_waits_for_wakes_it_once() -> None:
    def node() -> None:
        event = threading.Event()
        signal.signal(signal.SIGTERM, lambda *_: event.set())
        threading.Timer(1, os.kill, (os.getpid(), signal.SIGTERM)).start()
        event.wait()
        time.sleep(1)
        print(time.time())

    assert simulate(node, 5).console == "2.0\n"


def test_two_signals_at_once_are_both_handled() -> None:
    def node() -> None:
        def send() -> None:
            for number in (signal.SIGUSR1, signal.SIGUSR2):
                os.kill(os.getpid(), number)

        for number in (signal.SIGUSR1, signal.SIGUSR2):
            signal.signal(number, lambda number, frame: print(number))
        threading.Thread(target=send).start()
        time.sleep(1)

    assert simulate(node, 10).console == f"{signal.SIGUSR1:d}\n{signal.SIGUSR2:d}\n"


def test_an_alarm_rings_in_simulated_time() -> None:
    def node() -> None:
        signal.signal(signal.SIGALRM, lambda number, frame: print(time.time()))
        signal.setitimer(signal.ITIMER_REAL, 0.5, 1.0)
        time.sleep(2.6)
        print(round(signal.setitimer(signal.ITIMER_REAL, 0)[0], 6))
        time.sleep(5)

    assert simulate(node, 10).console == "0.5\n1.5\n2.5\n0.9\n"


def test_signals_that_python_ignores_or_that_nobody_can_handle() -> None:
    def node() -> None:
        os.kill(os.getpid(), 0)
        os.kill(os.getpid(), signal.SIGCHLD)
        with pytest.raises(OSError):
            os.kill(os.getpid(), 1000)
        with pytest.raises(OSError):
            signal.signal(signal.SIGKILL, signal.SIG_DFL)

    assert simulate(node, 1).status == 0


def test_two_pools_at_once() -> None:
    def node() -> None:
        rospy.init_node("node")
        pools = [ThreadPoolExecutor(1) for _ in range(2)]

        def ask(pool: ThreadPoolExecutor) -> None:
            print(pool.submit(threading.current_thread).result().name)

        for pool in pools:
            rospy.Timer(rospy.Duration(1), lambda event, pool=pool: ask(pool))  # type: ignore[misc]
        rospy.sleep(1.5)

    assert simulate(node, 5).console == "ThreadPoolExecutor-0_0\nThreadPoolExecutor-1_0\n"


def test_a_child_that_a_node_forks_does_not_come_back_to_the_host() -> None:
    def node() -> None:
        child = os.fork()
        if not child:
            os._exit(7)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))

    here = os.getpid()
    assert simulate(node, 1).console == "7\n"
    assert os.getpid() == here


def test_a_node_that_stands_in_line_for_a_processor_is_not_ended(
    impatient: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As on a machine that has too much to do; it works for twice as long as a node may that has a processor."""

    def node() -> None:
        done = time.process_time() + 0.9
        while time.process_time() < done:
            pass
        print("done")

    with monkeypatch.context() as patch:
        patch.setattr(watchdog._FromAThread, "_scheduled_until_now", lambda self: (0.0, time.perf_counter()))
        assert simulate(node, 1).console == "done\n"
    with pytest.raises(TimeStandsStill):
        simulate(node, 1)


def test_an_import_that_never_ends(write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(watchdog, "_INTERVAL", watchdog._INTERVAL)  # to be put back
    # It is given ten times as many looks. They are quick from the loop on: before it, it may have to wait for the disk.
    write("from rosspin.clocks import watchdog\nwatchdog._INTERVAL = 0.005\nwhile True: pass\n", "endless.py")
    with pytest.raises(TimeStandsStill, match="endless.py:3: "):
        simulate(write("import endless\n"), 1)


@pytest.mark.parametrize(("code", "status"), [("256", 0), ("-1", 255), ("ValueError('bad')", 1)])
def test_exit_statuses_are_those_of_a_process(write: Any, code: str, status: int) -> None:
    assert simulate(write(f"import sys\nsys.exit({code})\n"), 1).status == status


# --- clocks -----------------------------------------------------------------------------------------------------------


def test_functions_of_time_that_take_now_by_default_are_simulated() -> None:
    def node() -> None:
        time.sleep(1.5)
        print(time.gmtime().tm_sec, time.strftime("%S", time.gmtime()), time.gmtime(86400).tm_mday)

    assert simulate(node, 5).console == "1 01 2\n"


def test_the_time_of_the_processor_is_real() -> None:
    seen: list[float] = []

    def node() -> None:
        before = time.process_time()
        while time.process_time() < before + 0.01:
            pass
        seen.append(time.time())

    assert simulate(node, 1).status == 0
    assert seen == [0.0]


# --- what waits in real time ------------------------------------------------------------------------------------------


SERVES = "import asyncio\nasync def main():\n    await asyncio.start_server(print, 'localhost', 0)\n"
SERVES += "    await asyncio.sleep(60)\n"
SLEEPS = f"subprocess.run([{sys.executable!r}, '-c', 'import time; time.sleep(60)'])"


@pytest.mark.parametrize(
    ("code", "line", "call"),
    [
        (f"import subprocess\n{SLEEPS}\n", 2, SLEEPS),
        ("import socket\ns = socket.create_server(('localhost', 0))\ns.accept()\n", 3, "s.accept()"),
        ("import select\n\nselect.select([], [], [], 60)\n", 3, "select.select([], [], [], 60)"),
        (f"{SERVES}asyncio.run(main())\n", 5, "asyncio.run(main())"),
        ("import os\nread, write = os.pipe()\nos.fdopen(read).readline()\n", 3, "os.fdopen(read).readline()"),
    ],
)
def test_what_waits_in_real_time_is_named(impatient: None, write: Any, code: str, line: int, call: str) -> None:
    path = write(code)
    with pytest.raises(TimeStandsStill) as caught:
        simulate(path, 5)
    assert str(caught.value).startswith(f"{path}:{line}: {call}: simulated time stands still at 0.0 s, because this ")
    assert "waits in real time" in str(caught.value)


# --- the end ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("run", [simulate, measure])
def test_seconds_that_no_clock_can_hold(run: Any) -> None:
    with pytest.raises(ValueError, match=r"^seconds must be less than 9223372036 \(292 years\), not 1e\+300$"):
        run(lambda: None, 1e300)


def test_a_long_loop_of_looks_takes_few() -> None:
    """It sees the end of a thread nearly when it comes, and a run does not take longer than its time."""

    def node() -> None:
        thread = threading.Thread(target=time.sleep, args=[1.0])
        thread.start()
        looks = 0
        while thread.is_alive():
            looks += 1
        print(looks < 100_000, time.time() < 1.001)

    assert simulate(node, 2).console == "True True\n"


def test_a_turn_that_was_interrupted_goes_to_the_next_who_waits() -> None:
    def node() -> None:
        lock = threading.Lock()
        lock.acquire()

        def wait() -> None:
            time.sleep(1)
            with lock:
                print("the next one's turn")

        def release() -> None:
            time.sleep(2)
            lock.release()
            signal.raise_signal(signal.SIGINT)

        for target in (wait, release):
            threading.Thread(target=target).start()
        try:
            lock.acquire()
        except KeyboardInterrupt:
            print("interrupted")

    assert simulate(node, 5).console == "interrupted\nthe next one's turn\n"


def test_a_thread_that_is_stopped_by_the_end_of_the_run_reports_nothing() -> None:
    told = []

    def main() -> None:
        threading.excepthook = lambda args: told.append(args.exc_type)
        threading.Thread(target=time.sleep, args=(100,), daemon=True).start()
        time.sleep(1)

    assert simulate(main, 2).status == 0
    assert told == []
