"""Node files on the wall clock: each in a process of its own, of which nothing is left afterwards."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from shlex import quote
from typing import Any

import pytest
from jupyter_client.manager import start_new_kernel

from rosspin import NotSimulated, Tick, measure, simulate
from rosspin.clocks.ctrl_c import Ending
from rosspin.run.host import Host
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(10)

NEVER = 60  # s; only so that a test that hangs ends at all

TICKS = """
import sys, threading, rospy
rospy.init_node("node")
ticked = threading.Event()
def tick(event):
    sys.stdout.write("tick\\n")  # in one go, whatever comes then
    ticked.set()
rospy.Timer(rospy.Duration(0.02), tick)
ticked.wait()
"""

# Code in C in which Python handles no signal: one that keeps all other threads from running, and one that lets them.
HOLDS_ALL = "sum(range(10**15))\n"
LETS_OTHERS = """
import ctypes, signal
libc = ctypes.CDLL(None)
signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
libc.sleep(1000)
"""
CATCHES_ALL = """
import threading, time
def catches_all():
    while True:
        try:
            time.sleep(0.01)
        except BaseException:
            pass
threading.Thread(target=catches_all).start()
catches_all()
"""

PATIENCE = 0.5

# The same for another process.
IMPATIENT = f"from rosspin.run import host; host.Host.ending = host.Ending(((2, {PATIENCE}),))"


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    """A node that does not heed Ctrl-C is killed soon."""
    monkeypatch.setattr(Host, "ending", Ending(((signal.SIGINT, PATIENCE),)))


class Life:
    """A pipe with a name, which a node and all that it starts hold open with the lines ``hold``."""

    def __init__(self, path: Path) -> None:
        os.mkfifo(path)
        self.read = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        self.hold = f"import os\nlife = os.open({str(path)!r}, os.O_WRONLY)\nos.set_inheritable(life, True)\n"
        self.hold += "os.write(life, b'!')\n"

    def began(self) -> bool:
        """Wait until it is held, for the first time."""
        return bool(select.select([self.read], [], [], NEVER)[0] and os.read(self.read, 1))

    def ended(self) -> bool:
        """Wait until it is free again."""
        while select.select([self.read], [], [], NEVER)[0]:
            if not os.read(self.read, 1):
                return True
        return False


@pytest.fixture
def life(tmp_path: Path) -> Iterator[Life]:
    life = Life(tmp_path / "life")
    yield life
    os.close(life.read)


# --- a run ------------------------------------------------------------------------------------------------------------


def test_a_file_gives_what_it_gives_in_simulated_time(write: Any) -> None:
    node = write(
        """
        import sys

        import rospy
        from std_msgs.msg import Header, String

        class Shout(String):
            pass

        class Odd:
            pass

        rospy.init_node("node")
        publisher = rospy.Publisher("topic", Header, queue_size=1)
        publisher.publish(Header(stamp=rospy.Time(1, 2), frame_id="map"))
        rospy.Publisher("own", String, queue_size=1).publish(Shout("loud"))
        rospy.Publisher("odd", String, queue_size=1).publish(Odd())
        rate = rospy.Rate(50)
        for _ in range(3):
            rate.sleep()
        print("out", *sys.argv[1:])
        print("err", file=sys.stderr)
        print("é", file=sys.stderr)
        sys.stdout.buffer.write(b"bytes\\n")
        print("x" * 10_000)
        sys.exit(3)
        """
    )
    simulated, real = (run(node, NEVER, ["word"]) for run in (simulate, measure))
    assert (real.console, real.status, real.seconds) == (simulated.console, 3, NEVER)
    assert real.runtime == "wall" and real.start > 1e9
    assert [tick[:2] for tick in real.ticks] == [("Rate", 1), ("Rate", 2), ("Rate", 3)]
    assert all(type(tick) is Tick for tick in real.ticks)
    assert [message[:2] for message in real.messages] == [message[:2] for message in simulated.messages]
    header, own, odd = (message.message for message in real.messages)
    assert (header._type, header.frame_id, header.stamp.to_nsec()) == ("std_msgs/Header", "map", 1_000_000_002)
    assert (own._type, own.data, odd) == ("std_msgs/String", "loud", None)
    assert all(0 <= message.time < NEVER for message in real.messages)


def test_messages_of_its_own_package_and_neighbours(tmp_path: Path) -> None:
    package = tmp_path / "src" / "own_pkg"
    for folder in ("msg", "src"):
        (package / folder).mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>own_pkg</name></package>")
    (package / "msg" / "Speed.msg").write_text("float64 value\n")
    (package / "src" / "helper.py").write_text("from own_pkg.msg import Speed\n")
    node = package / "src" / "node.py"
    node.write_text(
        "import rospy\nfrom helper import Speed\nrospy.init_node('n')\n"
        "rospy.Publisher('speed', Speed, queue_size=1).publish(2.5)\n"
    )
    run = measure(node, NEVER)
    assert (run.console, [(of.topic, of.message.value) for of in run.messages]) == ("", [("/speed", 2.5)])


def test_it_sees_the_caller_s_path_folder_and_environment_and_changes_none(
    write: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    library = tmp_path / "library"
    library.mkdir()
    (library / "on_the_path.py").touch()
    monkeypatch.syspath_prepend(library)
    monkeypatch.chdir(library)
    monkeypatch.setenv("WORD", "mine")
    node = write(
        """
        import os, signal, on_the_path
        print(os.environ["WORD"], os.getcwd(), os.getppid())
        os.environ["WORD"] = "the node's"
        os.chdir("/")
        signal.signal(signal.SIGTERM, lambda number, frame: None)
        """
    )
    handler = signal.getsignal(signal.SIGTERM)
    assert measure(node, NEVER).console == f"mine {library} {os.getpid()}\n"
    assert (os.environ["WORD"], os.getcwd()) == ("mine", str(library))
    assert "on_the_path" not in sys.modules
    assert signal.getsignal(signal.SIGTERM) == handler


def test_its_standard_input_is_empty(write: Any) -> None:
    run = measure(write("import sys\nprint(repr(sys.stdin.read()))\ninput()\n"), NEVER)
    assert run.console.startswith("''\n") and run.console.endswith("EOFError: EOF when reading a line\n")


def test_several_at_once_and_not_in_the_main_thread(write: Any) -> None:
    # Each waits for the other one.
    nodes = [
        write(
            f"""
            import os, time
            os.mkdir("{{}}")
            while not os.path.exists("{{}}"):
                time.sleep(0.01)
            print("{name}")
            """.format(write("", name).with_suffix(".here"), write("", other).with_suffix(".here")),
            f"{name}.py",
        )
        for name, other in (("a", "b"), ("b", "a"))
    ]
    with ThreadPoolExecutor() as pool:
        runs = list(pool.map(lambda node: measure(node, NEVER), nodes))
    assert [(run.status, run.console) for run in runs] == [(0, "a\n"), (0, "b\n")]


# --- what prevents it -------------------------------------------------------------------------------------------------


def test_errors_are_raised_in_the_caller(write: Any) -> None:
    with pytest.raises(FileNotFoundError):
        measure("missing.py", 1)
    with pytest.raises(SyntaxError):
        measure(write("def ("), 1)
    with pytest.raises(ValueError, match="seconds must be a number of at least 0"):
        measure(write(""), -1)
    for text in ("import rospy\nrospy.MasterProxy\n", "import threading, rospy\nimport cv_bridge\n"):
        node = write(text)
        with pytest.raises(NotSimulated, match="(MasterProxy|cv_bridge) is not simulated; run this node") as caught:
            measure(node, NEVER)
        assert f'File "{node}", line 2, in <module>' in caught.value.__notes__[0]
    in_thread = write(
        """
        import threading, rospy
        rospy.init_node("node")
        threading.Thread(target=lambda: rospy.MasterProxy).start()
        rospy.spin()
        """
    )
    with pytest.raises(NotSimulated):
        measure(in_thread, NEVER)


def test_a_node_cannot_measure(write: Any) -> None:
    inner = write("")
    outer = write(f"import rosspin\nrosspin.measure({str(inner)!r}, 1)\n", "outer.py")
    for run in (simulate, measure):
        assert run(outer, NEVER).console.endswith("RuntimeError: a node cannot start a run of its own\n")


def test_a_process_that_does_not_start(write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    with pytest.raises(RuntimeError, match=r"did not start \(status 1\)"):
        measure(write(""), 1)


# --- its end ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("code", "place"),
    [
        (HOLDS_ALL, HOLDS_ALL.strip()),
        (LETS_OTHERS, "libc.sleep(1000)"),
        (CATCHES_ALL, "time.sleep(0.01)"),
    ],
)
def test_whatever_a_node_does_it_is_killed_and_nothing_of_it_runs_on(
    impatient: None, write: Any, life: Life, code: str, place: str
) -> None:
    starts = "import subprocess, sys\nsubprocess.Popen(['sleep', '1000'], close_fds=False)\nif os.fork() == 0:\n"
    node = write(f"{life.hold}{starts}    while True: pass\nprint('ready')\n{TICKS}{code}")
    line = next(number for number, text in enumerate(node.read_text().splitlines(), 1) if text.strip() == place)
    with control(bears=0.1):  # a slow node has not come that far at Ctrl-C
        run = measure(node, 1)
        assert run.status == 137
        lines = run.console.splitlines()
        assert lines[0] == "ready" and "tick" in lines
        said = "".join(f"{line}\n" for line in lines if line.startswith("rosspin: "))
        assert said.startswith(
            f"rosspin: Ctrl-C at 1 s did not end the node; it was killed {PATIENCE} s later, as roslaunch does. "
            f"Does its loop check rospy.is_shutdown()?\nrosspin: MainThread was at {node}:{line}"
        )
    assert life.ended()
    # What keeps all other threads from running takes with it what was recorded.
    assert bool(run.ticks) == (code != HOLDS_ALL)


def test_at_an_ordinary_end_nothing_is_left_either(write: Any, life: Life) -> None:
    node = write(f"{life.hold}import subprocess\nsubprocess.Popen(['sleep', '1000'], close_fds=False)\nprint('end')\n")
    run = measure(node, NEVER)
    assert (run.status, run.console) == (0, "end\n")
    assert life.ended()


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells what a thread blocks")
def test_a_node_that_blocks_ctrl_c_is_told_so(impatient: None, write: Any) -> None:
    node = write("import signal\nsignal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})\n" + SPINS)
    said = "rosspin: the main thread blocks SIGINT (signal.pthread_sigmask): Ctrl-C does not reach it"
    with control(bears=0.1):
        assert said in measure(node, 0.5).console.splitlines()


def test_a_node_that_ignores_ctrl_c_is_told_so(impatient: None, write: Any) -> None:
    ignores = "import signal, time\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
    node = write(ignores + "while True:\n    time.sleep(0.01)\n")
    with control(bears=0.1):
        assert "The node ignores Ctrl-C: signal.signal(signal.SIGINT, signal.SIG_IGN)." in measure(node, 0.5).console


def test_a_function_leaves_no_signal_blocked() -> None:
    assert measure(lambda: signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM}), NEVER).status == 0
    assert signal.SIGTERM not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


LEAVES = """
import subprocess
subprocess.Popen(["sleep", "1000"], close_fds=False, start_new_session=True, env={})
if os.fork() == 0:
    os.setsid()
    if os.fork() == 0:
        while True: pass
    os._exit(0)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells of processes that are in sessions of their own")
@pytest.mark.parametrize("code", ["", HOLDS_ALL, LETS_OTHERS, "raise RuntimeError"])
@pytest.mark.parametrize("apart", [True, False], ids=["measured", "on the command line"])
def test_what_is_in_a_session_of_its_own_ends_too(
    impatient: None, write: Any, life: Life, code: str, apart: bool
) -> None:
    node = write(f"{life.hold}{LEAVES}{code}")
    with control(bears=0.1):  # else Ctrl-C may come before it holds the pipe
        (measure(node, 0.5) if apart else run_on_the_command_line(node))
        assert life.ended()


def test_what_was_there_before_the_command_line_stays(write: Any) -> None:
    """A shell that becomes rosspin has started it."""
    words = map(quote, [sys.executable, "-m", "rosspin", "run", str(write("print(1)"))])
    command = f"sleep 1000 >&2 & echo $!; exec {' '.join(words)} >&2"
    done = subprocess.run(["sh", "-c", command], stdout=subprocess.PIPE, timeout=NEVER, text=True)
    os.kill(int(done.stdout), signal.SIGTERM)


def test_a_pool_whose_workers_heed_no_signal_does_not_keep_the_command_line(write: Any) -> None:
    """Python waits for them at its end."""
    deaf = "import multiprocessing, signal\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\n"
    done = run_on_the_command_line(
        write(f"{deaf}multiprocessing.Process(target=signal.pause, daemon=True).start()\nprint('end')\n"),
        NEVER,
    )
    assert (done.returncode, done.stdout) == (0, "end\n")


@pytest.mark.parametrize(("how", "status"), [("os.abort()", 134), ("os.kill(os.getpid(), 9)", 137), ("os._exit(4)", 4)])
def test_a_node_that_ends_abruptly(write: Any, how: str, status: int) -> None:
    run = measure(write(f"import os\nprint('hello')\n{how}\n"), NEVER)
    assert (run.status, run.console) == (status, "hello\n")


def test_what_a_child_of_the_node_prints_is_on_the_console(write: Any) -> None:
    run = measure(
        write(
            """
            import os
            child = os.fork()
            if child:
                os.waitpid(child, 0)
            print("parent" if child else "child")
            """
        ),
        NEVER,
    )
    assert (run.status, run.console) == (0, "child\nparent\n")


SPINS = "import rospy\nrospy.init_node('node')\nrospy.on_shutdown(lambda: print('hook'))\nrospy.spin()\n"


@pytest.mark.parametrize("begun", [True, False])
def test_ctrl_c_in_the_caller_is_for_the_node(write: Any, life: Life, begun: bool) -> None:
    """Also if it comes before the node has begun."""

    def press() -> None:
        if begun:
            life.began()
        # Not before `measure` listens.
        while signal.getsignal(signal.SIGINT) is before:
            pass
        os.kill(os.getpid(), signal.SIGINT)

    before = signal.getsignal(signal.SIGINT)
    threading.Thread(target=press).start()
    run = measure(write(life.hold + SPINS), NEVER)
    assert signal.getsignal(signal.SIGINT) is before
    # Early enough it is Python's own: rospy handles it only from init_node on.
    assert (run.status, run.console) == (0, "hook\n") or run.status == 130


def test_a_node_ends_with_its_caller(write: Any, life: Life) -> None:
    node = write(f"{life.hold}{TICKS}rospy.spin()\n")
    caller = subprocess.Popen([sys.executable, "-c", f"import rosspin; rosspin.measure({str(node)!r}, 1000)"])
    assert life.began()
    caller.kill()
    assert life.ended()
    caller.wait()


# --- the command line -------------------------------------------------------------------------------------------------


def run_on_the_command_line(node: Path, seconds: float = 0.5) -> subprocess.CompletedProcess[str]:
    code = f"{IMPATIENT}; import sys, rosspin.__main__ as m; sys.exit(m.main())"
    command = [sys.executable, "-c", code, "run", str(node), "--seconds", str(seconds)]
    return subprocess.run(command, capture_output=True, text=True, timeout=NEVER)


@pytest.mark.parametrize("code", [HOLDS_ALL, LETS_OTHERS, CATCHES_ALL])
def test_the_command_line_ends_whatever_a_node_does(write: Any, code: str) -> None:
    with control(bears=0.1):
        done = run_on_the_command_line(write(code))
        assert done.returncode in (137, -signal.SIGKILL)  # a shell calls both 137
        assert done.stderr.splitlines()[1].startswith(f"rosspin: MainThread was at {write(code)}:")


def test_a_thread_that_heeds_nothing_does_not_keep_the_command_line(write: Any) -> None:
    """Python would wait for it at its end."""
    code = f"import threading\ndef deaf():{LETS_OTHERS.replace(chr(10), chr(10) + '    ')}\n"
    with control(bears=0.1):
        done = run_on_the_command_line(write(f"{code}threading.Thread(target=deaf).start()\n{CATCHES_ALL}"))
        assert done.returncode == 137
        assert "(deaf) was at " in done.stderr


def test_a_node_that_forks_is_still_sent_ctrl_c(write: Any) -> None:
    node = write(f"import os\nif os.fork():\n    os.wait()\n    {SPINS.replace(chr(10), '; ')}\n")
    with control(bears=0.1):
        done = run_on_the_command_line(node, 2.0)
        assert (done.returncode, done.stdout, done.stderr) == (0, "hook\n", "")


# --- a notebook -------------------------------------------------------------------------------------------------------


def test_a_cell_of_a_notebook(tmp_path: Path) -> None:
    """In a real kernel, which has threads of its own."""
    first, second = Life(tmp_path / "first"), Life(tmp_path / "second")
    manager, client = start_new_kernel()

    def show(code: str) -> str:
        shown: list[str] = []

        def keep(message: dict[str, Any]) -> None:
            if message["msg_type"] == "stream":
                shown.append(message["content"]["text"])

        reply = client.execute_interactive(code, timeout=NEVER, output_hook=keep)
        assert reply["content"]["status"] == "ok"
        return "".join(shown)

    try:
        show(f"%load_ext rosspin\n{IMPATIENT}")
        with control(bears=0.1):
            shown = show(f"%%measure 1\n{first.hold}{HOLDS_ALL}")
            assert "did not end the node" in shown and "rosspin: MainThread was at <cell " in shown
        assert first.ended()
        assert show("print(run.status, run.ticks)") == "137 ()\n"

        threading.Thread(target=lambda: second.began() and manager.interrupt_kernel()).start()
        assert show(f"%%measure {NEVER}\n{SPINS.replace('rospy.spin', second.hold + 'rospy.spin')}") == "hook\n"
        assert show("print(run.status)") == "0\n"
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
