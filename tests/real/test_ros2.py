"""The real ROS 2: nodes run there, a package of them is built, ticks are told, and nothing is left over."""

from __future__ import annotations

import io
import math
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise
from pathlib import Path
from statistics import fmean
from textwrap import dedent
from typing import Any

import pytest

from rosspin import simulate
from rosspin.__main__ import main
from rosspin.clocks.ctrl_c import Ending
from rosspin.measures import by_source
from rosspin.real import ros2
from rosspin.real.children import Output
from tests.helpers.chatter import CHATTER
from tests.helpers.launches import NEVER, launch, launch_past, unspoilt
from tests.helpers.leftovers import processes
from tests.helpers.tree import ROOT
from tests.helpers.verdicts import control

pytestmark = [pytest.mark.usefixtures("leaves_nothing"), pytest.mark.shares(10)]

EXAMPLES = ROOT / "examples"
PACKAGE = EXAMPLES / "my_robotics_pkg_ros2"
NODES = PACKAGE / "my_robotics_pkg"
TIMER_NODE = NODES / "spinner_py_node.py"

# A node with a timer of 0.2 s, whose callback is the text that is put in.
TIMER = """
    import os, signal, sys, time
    import rclpy
    def timer_callback():
        {callback}
    rclpy.init()
    node = rclpy.create_node("node")
    node.create_timer(0.2, timer_callback)
    rclpy.spin(node)
"""


@pytest.fixture
def ros(require: Callable[[str], None]) -> None:
    require("ros2")


# --- runs -------------------------------------------------------------------------------------------------------------


def test_a_timer_node(ros: None) -> None:
    live = io.StringIO()
    with control(bears=0.1):  # a late Ctrl-C comes in the midst of a tick
        run = launch(TIMER_NODE, 2.3, ["--ros-args", "-r", "__ns:=/mrp"], live)
        assert (run.runtime, run.status, run.seconds) == ("ros2", 0, 2.3)
        assert live.getvalue() == run.console
        lines = [line.partition("[SPINNER")[0::2] for line in run.console.splitlines()]
        assert all(head.startswith("[INFO] [") and head.endswith("] [mrp.spinner_py_node]: ") for head, _ in lines)
        numbers = range(1, len(run.ticks) + 1)
        wanted = ["namespace of node = /mrp", *(f"counter = {number}" for number in numbers)]
        assert [text for _, text in lines] == [f" PY NODE] {text}" for text in wanted]
        assert [tick.number for tick in run.ticks] == list(numbers)
        for tick in run.ticks:
            assert tick.source == "timer_callback"
            assert 0 <= tick.lateness
            assert tick.duration > 0
            assert math.remainder(tick.expected - run.ticks[0].expected, 0.5) == pytest.approx(0, abs=0.1)


@pytest.mark.parametrize("name", ["plain", "spinner", "spinner_rate", "spinner_param"])
def test_the_nodes_of_the_package(ros: None, name: str) -> None:
    node = NODES / f"{name}_py_node.py"
    run = launch(node, 1.2) if name == "plain" else launch_past("counter = 2", node)
    assert run.status == 0
    assert "Traceback" not in run.console
    assert bool(run.ticks) == (name != "plain")


def test_a_parameter(ros: None) -> None:
    node = NODES / "spinner_param_py_node.py"
    with control(bears=0.05):  # a late node skips ticks
        fast = launch_past("counter = 15", node, ["--ros-args", "-p", "frequency:=20.0"])
        periods = [later.expected - earlier.expected for earlier, later in pairwise(fast.ticks)]
        assert min(periods) < 0.1 and fmean(periods) > 0.04
    refused = ros2.launch(node, NEVER, ["--ros-args", "-p", "frequency:=0.0"])
    assert refused.status == 1
    assert "[FATAL]" in refused.console and "frequency must be above 0" in refused.console


def test_ticks_of_timers_and_rates(ros: None, write: Any) -> None:
    node = write(
        """
        import functools, threading, time
        import rclpy
        def slow():
            time.sleep(0.3)
        def loop():
            while rclpy.ok():
                rate.sleep()
        rclpy.init()
        node = rclpy.create_node("node")
        node.create_timer(0.2, slow)
        node.create_timer(0.5, functools.partial(slow))
        node.create_timer(0.5, slow).cancel()
        rate = node.create_rate(2)
        threading.Thread(target=loop, daemon=True).start()
        rclpy.spin(node)
        """
    )
    with control(bears=0.1):
        run = ros2.launch(node, 2.0)
        sources = by_source(run.ticks)
        assert set(sources) == {"slow", "partial", "Rate"}
        assert len(sources["Rate"]) > 1
        assert sources["Rate"][0].expected < 0.2 < sources["slow"][0].expected
    assert [tick.real for tick in run.ticks] == sorted(tick.real for tick in run.ticks)
    assert all(tick.duration >= 0.3 or math.isnan(tick.duration) for tick in sources["slow"][:-1])
    assert sources["Rate"][1].real >= sources["Rate"][1].expected


def test_a_callback_that_raises_has_its_own_traceback(ros: None, write: Any) -> None:
    run = ros2.launch(write(TIMER.format(callback="1 / 0")), NEVER)
    assert run.status == 1
    assert run.console.endswith("ZeroDivisionError: division by zero\n")
    assert "rosspin" not in run.console.replace(str(ROOT), "")
    assert len(run.ticks) == 1


def test_ctrl_c_that_nobody_catches(ros: None, write: Any) -> None:
    node = write(TIMER.format(callback="pass"))
    run = launch(node, 0.7)
    assert run.status == 128 + signal.SIGINT
    assert run.console.endswith("KeyboardInterrupt\n")


@pytest.mark.parametrize(
    ("callback", "status"),
    [("sys.exit(3)", 3), ("os._exit(4)", 4), ("rclpy.shutdown()", 0)],
)
def test_a_node_that_ends_by_itself(ros: None, write: Any, callback: str, status: int) -> None:
    run = ros2.launch(write(TIMER.format(callback=callback)), NEVER)
    assert (run.status, run.console) == (status, "")


def test_threads_print_whole_lines(ros: None, write: Any) -> None:
    assert {*ros2.launch(write(CHATTER), NEVER).console.splitlines()} == {"one", "two"}


def test_a_killed_node_leaves_nothing(ros: None, write: Any) -> None:
    """Nor does it have any memory that it would share: Fast DDS leaves that behind."""
    told = "print([line for line in open('/proc/self/maps') if 'fastrtps' in line and '/dev/shm' in line], flush=True)"
    run = ros2.launch(write(TIMER.format(callback=f"{told}; os.kill(os.getpid(), signal.SIGKILL)")), NEVER)
    assert run.status == 128 + signal.SIGKILL
    assert run.console == "[]\nrosspin: node.py ended with status 137 (SIGKILL)\n"


def test_a_node_deaf_to_ctrl_c_is_killed(ros: None, write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ros2.Nodes, "ending", Ending(((signal.SIGINT, 2.0), (signal.SIGTERM, 0.5))))
    node = write(
        """
        import rclpy
        rclpy.init()
        node = rclpy.create_node("node")
        rate = node.create_rate(2)
        while True:
            try:
                print("begun")
                rate.sleep()
            except KeyboardInterrupt:
                print("no")
        """
    )
    with control(bears=0.5):  # it is given 2 s to restart
        run = launch_past("begun", node)
        assert run.console == "begun\nno\nbegun\nrosspin: node.py ended with status 137 (SIGKILL)\n"


def test_nodes_do_not_meet_unless_they_are_to(ros: None, write: Any) -> None:
    node = write(
        """
        import sys
        import rclpy
        from rclpy.wait_for_message import wait_for_message
        from std_msgs.msg import String
        rclpy.init()
        node = rclpy.create_node(sys.argv[1])
        if node.get_name() == "talker":
            publisher = node.create_publisher(String, "words", 10)
            node.create_timer(0.1, lambda: publisher.publish(String(data="word")))
            rclpy.spin(node)
        print(wait_for_message(String, node, "words", time_to_wait=float(sys.argv[2])))
        """
    )
    heard = "(True, std_msgs.msg.String(data='word'))\n"
    for meet, patience, wanted in ((False, "2", "(False, None)\n"), (True, str(NEVER), heard)):
        with ros2.Nodes(meet) as nodes:
            talker = nodes.start([ros2.python(), str(node), "talker"], subprocess.DEVNULL, subprocess.DEVNULL)
            assert nodes.launch(node, 2 * NEVER, ["listener", patience]).console == wanted
            assert talker.poll() is None


def test_the_caller_s_environment_does_not_matter(ros: None, write: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {
        **{"ROS_DOMAIN_ID": "300", "RMW_IMPLEMENTATION": "nonsuch", "RCUTILS_LOGGING_USE_STDOUT": "1"},
        **{"_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "RCUTILS_CONSOLE_OUTPUT_FORMAT": "x", "PYTHONPATH": "/nonsuch"},
    }.items():
        monkeypatch.setenv(name, value)
    run = launch_past("counter = 1", TIMER_NODE)
    assert run.status == 0
    assert "[spinner_py_node]: [SPINNER PY NODE] counter = 1\n" in run.console


# --- from the command line --------------------------------------------------------------------------------------------


def test_the_command_line(ros: None, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    plot = tmp_path / "ticks.svg"
    command = ["run", "--ros2", str(TIMER_NODE), "--seconds", "1.7", "--plot", str(plot)]
    with control(bears=0.1):
        status = main([*command, "--", "--ros-args", "-r", "__node:=renamed"])
        out, err = capfd.readouterr()
        unspoilt(out)
        assert status == 0
        assert "[renamed]: [SPINNER PY NODE] counter = 1\n" in out
        assert "timer_callback: " in err
        assert plot.exists()


# Without rclpy.init(): Ctrl-C in the middle of a callback now and then meets rclpy's own shutdown half-way.
WAITING = """
    import time
    import rclpy
    try:
        print("begun")
        time.sleep(1000)
    except KeyboardInterrupt:
        print("over")
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_everything(ros: None, write: Any, leaves_nothing: Path, number: signal.Signals) -> None:
    command = [sys.executable, "-m", "rosspin", "run", "--ros2", str(write(WAITING))]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert process.stdout is not None
    console = ""
    while "begun" not in console:
        console += process.stdout.readline()
    assert len(processes(leaves_nothing)) == 1
    process.send_signal(number)
    console += process.communicate()[0]
    assert (process.returncode, console) == (0, "begun\nover\n")


def test_where_ctrl_c_is_ignored_nodes_still_heed_it(ros: None) -> None:
    """As in a shell's background jobs."""
    node = str(EXAMPLES / "ros2" / "endings" / "spin.py")
    command = [sys.executable, "-m", "rosspin", "run", "--ros2", node, "--seconds", "0.75"]
    deaf = "import signal, subprocess, sys; signal.signal(signal.SIGINT, signal.SIG_IGN); sys.exit(subprocess.call({}))"
    shell = partial(subprocess.run, [sys.executable, "-c", deaf.format(command)], capture_output=True, text=True)
    run = shell()
    unspoilt(run.stdout)
    assert run.returncode == 128 + signal.SIGINT
    assert run.stdout.endswith("KeyboardInterrupt\n")


def test_a_console_that_is_closed_ends_the_run(ros: None, write: Any) -> None:
    class Closed(io.StringIO):
        def write(self, text: str) -> int:
            if "begun" in text:
                raise BrokenPipeError
            return len(text)

    run = ros2.launch(write(WAITING), onward=Closed())
    assert (run.status, run.console) == (0, "begun\nover\n")


@pytest.mark.parametrize("killed", [False, True], ids=["at Ctrl-C", "at SIGTERM"])
def test_the_last_message_of_the_node_on_the_page_is_heard(ros: None, write: Any, killed: bool) -> None:
    """The node listens to itself, also for a while after the signal."""
    text = (EXAMPLES / "ros2" / "last_message_py_node.py").read_text(encoding="utf-8")
    listens = "    node.create_subscription(Float64, 'speed', lambda message: print('heard', message.data), 10)\n"
    kills = "    import os, threading\n    threading.Timer(1.2, os.kill, (os.getpid(), signal.SIGTERM)).start()\n"
    made, sent = "    node = DriverPyNode()\n", "        node.publisher.publish(Float64(data=0.0))\n"
    assert made in text and sent in text
    text = text.replace(made, made + listens + kills * killed)
    text = text.replace(sent, f"{sent}        for _ in range(3):\n            rclpy.spin_once(node, timeout_sec=0.4)\n")
    for run in (launch(write(text), NEVER if killed else 1.2), simulate(write(text), NEVER if killed else 1.2)):
        assert run.status == 0, run.console
        assert "heard 0.0" in run.console.splitlines()


# --- what goes wrong --------------------------------------------------------------------------------------------------


@pytest.fixture
def forgetful() -> Iterator[None]:
    """ROS 2 is looked for again, and again after the test."""
    caches: Any = (ros2.python, ros2.version)
    for cache in caches:
        cache.cache_clear()
    yield
    for cache in caches:
        cache.cache_clear()


def test_a_ros_2_that_has_been_sourced(
    ros: None, forgetful: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its Python is the system's; what its set-up puts into the environment stays there."""
    python = tmp_path / "python3"
    python.write_text(f'#!/bin/sh\nexport PYTHONPATH="${{PYTHONPATH%%:*}}"\nexec {shlex.quote(ros2.python())} "$@"\n')
    python.chmod(0o755)
    monkeypatch.setattr(ros2, "_MADE", tmp_path / "nowhere")
    monkeypatch.setattr(ros2, "_SYSTEM", str(tmp_path))
    monkeypatch.setenv("AMENT_PREFIX_PATH", "/opt/ros/jazzy")
    monkeypatch.setenv("PYTHONPATH", "/opt/ros/jazzy/lib/python3/site-packages")
    ros2.python.cache_clear()
    ros2.version.cache_clear()
    assert ros2.python() == str(python)
    assert launch_past("counter = 1", TIMER_NODE).ticks


# --- the package ------------------------------------------------------------------------------------------------------


TUTORIAL = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "docs/ros2").glob("tutorial*.rst"))
BASH = re.compile(r"^( *)\.\. code-block:: bash\n(?: +:caption: .*\n)?\n((?:\1   .*\n|\n)+)", re.MULTILINE)
SAVED = re.compile(r"^ *\.\. literalinclude:: (.*)\n(?: +:(?!caption).*\n)* +:caption: (.*)", re.MULTILINE)
# For a ROS 2 of the system's and the command ros2, which there need not be, or for nodes in C++.
NOT_RUN = re.compile(r"source /opt/ros|ros2 |.*my_robotics_pkg_cpp", re.DOTALL)


def with_colcon(folder: Path) -> str:
    """A PATH with the ROS 2 that is installed, by a link: colcon bears no space in the path of its Python."""
    (folder / "bin").mkdir(parents=True)
    (folder / "ros2").symlink_to(Path(ros2.python()).parent.parent)
    colcon = folder / "bin/colcon"
    colcon.write_text(f'#!/bin/sh\nexec {folder}/ros2/bin/python {folder}/ros2/bin/colcon "$@"\n')
    colcon.chmod(0o755)
    return f"{folder}/bin:{folder}/ros2/bin:{os.environ['PATH']}"


def test_the_tutorial_builds_its_package_and_runs_it(ros: None, tmp_path: Path) -> None:
    """By its own commands, with the files where the captions say: what ``ros2 run`` would start is there and starts."""
    sections = TUTORIAL.partition("\nMake a package and build it\n")[2].partition("\nStop the node\n")[0]
    commands = [dedent(found[2]).strip() for found in BASH.finditer(sections)]
    make_folders, build, source = (code for code in commands if not NOT_RUN.match(code))
    (run,) = re.findall(r"^ros2 run my_robotics_pkg (.*)", "\n".join(commands), re.MULTILINE)
    assert "``python3 spinner_py_node.py`` runs the file" in sections
    with ros2.Nodes() as nodes:
        package = nodes.folder / "my-robotics-system/ros2_ws/src/my_robotics_pkg"
        home = {"HOME": str(nodes.folder), "PATH": with_colcon(tmp_path / "colcon")}

        def type_in(*lines: str, seconds: float = 300, begins: re.Pattern[str] | None = None) -> Output:
            return nodes.run(["bash", "-c", "\n".join(("set -e", *lines))], seconds, begins=begins, more=home)

        assert type_in(make_folders).status == 0
        for path, caption in SAVED.findall(TUTORIAL):
            if "steps_ros2" not in path and not path.endswith(".cpp") and "_cpp/" not in path:
                shutil.copy(ROOT / "docs" / "ros2" / path, package / caption)
        tree = re.search(r"ros2_ws/src/my_robotics_pkg/\n\n?((?: {7}.*\n)+)", sections)
        assert tree
        shown = {line.strip().rstrip("/") for line in tree[1].splitlines()} | {"spinner_rate_py_node.py"}
        assert {path.name for path in package.rglob("*")} == shown
        built = type_in(build)
        assert built.status == 0, built.console
        assert "``Finished <<<`` and the name of your package" in TUTORIAL
        assert "Finished <<< my_robotics_pkg" in built.console
        installed = "~/my-robotics-system/ros2_ws/install/my_robotics_pkg/lib/my_robotics_pkg"
        file = f"{package}/my_robotics_pkg/spinner_py_node.py --ros-args -r __ns:=/mrp"
        for command in (f"{source}\nexec {installed}/{run}", f"exec python3 {file}"):
            output = type_in(f"{command} > $HOME/stdout", seconds=0.25, begins=re.compile("counter = 2"))
            unspoilt(output.console)
            assert output.status == 0
            assert "] [mrp.spinner_py_node]: [SPINNER PY NODE] counter = 2\n" in output.console
            assert (nodes.folder / "stdout").read_text() == ""


def test_both_nodes_of_the_second_tutorial_are_installed_as_one_program(ros: None, tmp_path: Path) -> None:
    with ros2.Nodes() as nodes:
        shutil.copytree(PACKAGE, nodes.folder / "src/my_robotics_pkg", ignore=shutil.ignore_patterns("__pycache__"))
        path = {"PATH": with_colcon(tmp_path / "colcon")}
        built = nodes.run(["bash", "-c", f"cd {nodes.folder} && colcon build"], 300, more=path)
        assert built.status == 0, built.console
        program = "install/my_robotics_pkg/lib/my_robotics_pkg/both_py_nodes"
        start = f"cd {nodes.folder} && source install/setup.bash && exec {program}"
        run = nodes.run(["bash", "-c", start], 0.25, begins=re.compile("counter = 2"), more=path)
        simulated = simulate(NODES / "both_py_nodes.py", 1.0)
        said, wanted = ([line.partition("]: ")[2] for line in each.console.splitlines()] for each in (run, simulated))
        assert said[:4] == wanted
        assert run.status == 0


def test_a_whole_number_for_a_float_is_garbage_unless_fields_are_checked(
    ros: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the tutorial on topics warns, and says what to do. The stand-in always checks."""
    node = EXAMPLES / "topics/ros2/whole_py_node.py"
    # The bits of an int, which Python 3.12 has laid out in another way.
    launch_past(r"speed = (5e-324|4e-323)\n", node)
    monkeypatch.setenv("ROS_PYTHON_CHECK_FIELDS", "1")
    checked = ros2.launch(node, NEVER)
    assert checked.status == 1
    assert checked.console.splitlines()[-1] == simulate(node, 0.8).console.splitlines()[-1]


def test_a_node_may_import_its_own_package_and_is_told_what_messages_there_are(ros: None, tmp_path: Path) -> None:
    package = tmp_path / "own_pkg"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "helper.py").write_text("value = 1")
    node = package / "node.py"
    begin = "import rclpy; from own_pkg.helper import value; rclpy.init(); rclpy.create_node('n'); print(value)\n"
    node.write_text(f"{begin}import nav2_msgs.msg\n")
    onward = io.StringIO()
    run = ros2.launch(node, NEVER, onward=onward)
    assert run.status == 1
    assert run.console.startswith("1\n")
    assert run.console == onward.getvalue()
    last = run.console.splitlines()[-1]
    assert re.fullmatch("rosspin: make ros2 does not install nav2_msgs; its message packages are .*std_msgs.*", last)
