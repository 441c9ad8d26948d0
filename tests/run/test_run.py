"""simulate and measure: what a run gives, and that it leaves nothing behind."""

from __future__ import annotations

import inspect
import logging
import math
import os
import pickle
import random
import re
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable
from importlib import import_module
from linecache import getline
from pathlib import Path
from typing import Any

import pytest

import rosspin
from rosspin import NotSimulated, Tick, TimeStandsStill, measure, rospy, simulate, start
from rosspin.clocks.simulation import Simulation
from rosspin.run.explain import say_error
from rosspin.run.simulate import run_node
from rosspin.run.source import load, load_source
from tests.helpers.tree import ROOT

EXAMPLES = ROOT / "examples" / "my_robotics_pkg" / "src"
TIMER_NODE, RATE_NODE = EXAMPLES / "spinner_py_node.py", EXAMPLES / "spinner_rate_py_node.py"


# --- the examples -----------------------------------------------------------------------------------------------------


def counters(*times: float) -> str:
    return "".join(f"[INFO] [{time:.6f}]: [SPINNER PY NODE] counter = {n}\n" for n, time in enumerate(times, 1))


NAMESPACE = "[INFO] [0.000000]: [SPINNER PY NODE] namespace of node = /\n"


def test_the_timer_node_counts_from_one_period_on() -> None:
    run = simulate(TIMER_NODE, 2.0)
    assert run.console == NAMESPACE + counters(0.5, 1.0, 1.5, 2.0)
    assert run.ticks == tuple(Tick("timerCallback", n, n / 2, n / 2, 0.0) for n in range(1, 5))
    assert (run.status, run.runtime, run.seconds, run.start) == (0, "simulated", 2.0, 0.0)


def test_the_rate_node_counts_from_zero_on() -> None:
    run = simulate(RATE_NODE, 2.0)
    assert run.console == NAMESPACE + counters(0.0, 0.5, 1.0, 1.5, 2.0)
    # The last pass sleeps on when Ctrl-C comes, and ends its sleep.
    assert run.ticks == tuple(Tick("Rate", n, (n - 1) / 2, (n - 1) / 2, 0.0) for n in range(1, 6))
    assert run.status == 0


@pytest.mark.parametrize("node", [TIMER_NODE, RATE_NODE], ids=lambda path: path.stem)
def test_the_same_run_gives_the_same_bytes(node: Path) -> None:
    assert simulate(node, 100) == simulate(node, 100)


def test_arguments_reach_the_node() -> None:
    assert "namespace of node = /mrp/\n" in simulate(TIMER_NODE, 0, ["__ns:=/mrp"]).console


# --- the end of a run -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("seconds", "ticks"), [(0, 0), (0.499999999, 0), (0.5, 1), (0.999999999, 1), (1, 2), (1.0, 2)])
def test_what_falls_due_exactly_at_the_end_still_runs(seconds: float, ticks: int) -> None:
    assert len(simulate(TIMER_NODE, seconds).ticks) == ticks


def test_what_falls_due_at_the_end_runs_to_its_own_end() -> None:
    def callback(event: object) -> None:
        rospy.sleep(0.05)
        rospy.loginfo("done")

    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), callback)
        rospy.spin()

    # Like a thread on a real ROS, while the main thread is still on its way out.
    assert simulate(node, 0.5).console == "[INFO] [0.550000]: done\n"


def test_no_timer_calls_back_after_ctrl_c() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.01), lambda event: None)
        rospy.spin()

    assert simulate(node, 1.0).ticks[-1].real == 1.0


def test_a_node_that_ends_earlier_ends_the_run() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(1), lambda event: None)
        rospy.sleep(3.5)

    assert len(simulate(node, 1e9).ticks) == 3


def test_a_tick_that_has_not_ended_has_no_duration() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), lambda event: rospy.sleep(100))
        rospy.spin()

    (tick,) = simulate(node, 1).ticks
    assert math.isnan(tick.duration)
    assert tick.lateness == 0.0


def test_before_init_node_ctrl_c_is_python_s_own() -> None:
    run = simulate(lambda: time.sleep(100), 1)
    assert run.console.startswith("Traceback (most recent call last):\n")
    assert run.console.endswith("KeyboardInterrupt\n")
    assert run.status == 130


def test_a_node_deaf_to_ctrl_c_is_killed() -> None:
    def node() -> None:
        rospy.init_node("node")
        while True:
            rospy.sleep(1)

    run = simulate(node, 2)
    assert run.status == 137
    first, second = run.console.splitlines()
    assert first == (
        "rosspin: Ctrl-C at 2 s did not end the node; it was killed 17 s later, as roslaunch does. "
        "Does its loop check rospy.is_shutdown()?"
    )
    assert re.fullmatch(r"rosspin: MainThread was at .*test_run\.py:\d+: rospy\.sleep\(1\)", second)


def test_one_that_ignores_ctrl_c_is_told_so(write: Any) -> None:
    spins = "import signal, rclpy\nrclpy.init()\n{}rclpy.spin(rclpy.create_node('node'))\n"
    ignores = "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
    first, second = simulate(write(spins.format(ignores)), 2).console.splitlines()
    assert first == (
        "rosspin: Ctrl-C at 2 s did not end the node; it was killed 17 s later. "
        "The node ignores Ctrl-C: signal.signal(signal.SIGINT, signal.SIG_IGN)."
    )
    assert "MainThread was at" in second
    own = "signal.signal(signal.SIGINT, lambda *_: None)\n"
    assert "Does its loop check rclpy.ok()?" in simulate(write(spins.format(own)), 2).console


@pytest.mark.parametrize(
    ("code", "status", "console"),
    [
        ("", 0, ""),
        ("raise SystemExit", 0, ""),
        ("raise SystemExit(0)", 0, ""),
        ("raise SystemExit(3)", 3, ""),
        ("import sys; sys.exit('no robot')", 1, "no robot\n"),
        ("import rospy; raise rospy.ROSInterruptException('over')", 1, None),
    ],
)
def test_exit_statuses(write: Any, code: str, status: int, console: str | None) -> None:
    run = simulate(write(code), 1)
    assert run.status == status
    assert console is None or run.console == console


def test_a_run_within_a_simulated_run_is_an_error() -> None:
    run = simulate(lambda: simulate(print, 1.0), 1.0)
    assert run.status == 1
    assert run.console.endswith("RuntimeError: a node cannot start a run of its own\n")


def test_an_exception_in_main_shows_the_node_s_own_frames(write: Any) -> None:
    path = write(
        """
        import rospy

        def pick(robots):
            return robots["arm"]

        rospy.init_node("node")
        rospy.on_shutdown(lambda: print("hook"))
        pick({})
        """
    )
    run = simulate(path, 1)
    assert run.status == 1
    lines = [line for line in run.console.splitlines() if set(line) - set(" ^~")]
    assert lines == [
        "Traceback (most recent call last):",
        f'  File "{path}", line 9, in <module>',
        "    pick({})",
        f'  File "{path}", line 5, in pick',
        '    return robots["arm"]',
        "KeyError: 'arm'",
        "hook",
    ]


@pytest.mark.parametrize("separator", ["\u2028", "\x0c", "\x85", "\x1c"])
def test_a_traceback_shows_its_line_below_what_is_no_end_of_a_line(tmp_path: Path, separator: str) -> None:
    path = tmp_path / "node.py"
    path.write_text(f"text = 'a{separator}b'\n# {separator} #\n1 / 0\n", encoding="utf-8")
    assert '", line 3, in <module>\n    1 / 0\n' in simulate(path, 1).console


def test_a_syntax_warning_shows_a_line_of_its_own_text(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = []
    monkeypatch.setattr(warnings, "showwarning", lambda _m, _c, name, line, *_: shown.append(getline(name, line)))
    load_source("an_earlier_text = 1\n", "<node>")
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        load_source("print(1 is 1)\n", "<node>")
    assert shown == ["print(1 is 1)\n"]


# --- virtual time -----------------------------------------------------------------------------------------------------


def test_the_time_module_is_virtual_in_a_simulated_run() -> None:
    seen = []

    def node() -> None:
        for _ in range(2):
            seen.append([time.time(), time.monotonic(), time.perf_counter()])
            seen.append([time.time_ns() / 1e9, time.monotonic_ns() / 1e9, time.perf_counter_ns() / 1e9])
            time.sleep(1.5)
        with pytest.raises(ValueError, match="^sleep length must be non-negative$"):
            time.sleep(-1)
        with pytest.raises(TypeError, match="^'<' not supported between instances of 'str' and 'int'$"):
            time.sleep("1")  # type: ignore[arg-type]

    before = time.time, time.sleep, threading.Thread.start
    assert simulate(node, 10).status == 0
    assert seen == [[0.0] * 3] * 2 + [[1.5] * 3] * 2
    assert (time.time, time.sleep, threading.Thread.start) == before
    assert time.time() > 1e9


def test_names_taken_from_the_time_module_are_virtual_too(write: Any) -> None:
    path = write("from time import sleep, time\nsleep(2.5)\nprint(time())")
    assert simulate(path, 10).console == "2.5\n"


def test_other_threads_keep_the_real_time() -> None:
    seen: list[float] = []

    def node() -> None:
        ask.set()
        answered.wait(30)

    def outside() -> None:
        ask.wait(30)
        seen.append(time.time())
        answered.set()

    ask, answered = threading.Event(), threading.Event()
    thread = threading.Thread(target=outside)
    thread.start()
    simulate(node, 1)
    thread.join()
    assert seen[0] > 1e9


# --- clean worlds -----------------------------------------------------------------------------------------------------


def test_two_runs_do_not_see_each_other(write: Any) -> None:
    path = write(
        """
        import rospy
        print(rospy.core.is_shutdown(), rospy.get_name())
        rospy.init_node("node")
        print(rospy.has_param("~p"), rospy.get_time())
        rospy.set_param("~p", 1)
        for _ in range(2):
            rospy.loginfo_once("once")
            rospy.loginfo_throttle(60, "throttled")
        rospy.on_shutdown(lambda: print("hook"))
        rospy.Timer(rospy.Duration(1), lambda event: 1 / 0)
        rospy.sleep(1.5)
        """
    )
    first, second = simulate(path, 10), simulate(path, 10)
    assert first == second
    assert first.console.startswith("False /unnamed\nFalse 0.0\n")
    assert [first.console.count(text) for text in ("]: once\n", "]: throttled\n")] == [1, 1]
    assert "Exception in thread Thread-1:" in first.console
    assert first.console.endswith("hook\n")


def test_a_rospy_that_was_imported_before_comes_back(monkeypatch: pytest.MonkeyPatch, write: Any) -> None:
    monkeypatch.setitem(sys.modules, "rospy", sys)  # whatever it was
    assert simulate(write("import rospy; print(rospy.__name__)"), 1).console == "rosspin.rospy\n"
    assert sys.modules["rospy"] is sys


def test_a_neighbour_of_the_node_is_imported_anew(write: Any) -> None:
    node = write("import neighbour\nneighbour.values.append(1)\nprint(neighbour.values)")
    write("values = []", "neighbour.py")
    assert simulate(node, 1).console == simulate(node, 1).console == "[1]\n"
    os.unlink(node.parent / "neighbour.py")
    (node.parent / "neighbour").mkdir()
    write("values = [0]", "neighbour/__init__.py")
    assert simulate(node, 1).console == simulate(node, 1).console == "[0, 1]\n"


def test_a_function_finds_the_program_that_it_is_of() -> None:
    """As ``inspect.stack()`` does."""
    found = []
    simulate(lambda: found.append((sys.modules["__main__"], inspect.stack()[0].function)), 0)
    assert found == [(sys.modules["__main__"], "<lambda>")]


def test_a_launch_file_of_ros_2_finds_the_path_of_a_package(tmp_path: Any) -> None:
    (tmp_path / "package.xml").write_text("<package><name>mine</name></package>")
    file = tmp_path / "path.launch.py"
    file.write_text(
        "from ament_index_python.packages import get_package_share_path\n"
        "from launch import LaunchDescription\nfrom launch.actions import LogInfo\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([LogInfo(msg=f'in {get_package_share_path(\"mine\").name}')])\n"
    )
    assert f"in {tmp_path.name}" in simulate(file, 1).console


@pytest.mark.parametrize("layout", ["isolated", "merged"])
def test_an_installed_node_finds_what_was_installed_with_it(layout: str, tmp_path: Path) -> None:
    """As ``colcon build`` installs a package of nodes and one of messages, with and without --merge-install."""
    names = ("robots", "robot_msgs")
    prefixes = {name: tmp_path / "install" / (name if layout == "isolated" else "") for name in names}
    for name, prefix in prefixes.items():
        (prefix / "share" / name).mkdir(parents=True)
        (prefix / "share" / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    share = prefixes["robot_msgs"] / "share" / "robot_msgs"
    (share / "msg").mkdir()
    (share / "msg" / "Gear.msg").write_text("uint8 number 3\n")
    package = prefixes["robots"] / "lib" / "python3.12" / "site-packages" / "robots"
    package.mkdir(parents=True)
    (package / "__init__.py").touch()
    (package / "node.py").write_text(
        "import rclpy\nfrom ament_index_python import get_package_share_directory as find\n"
        "from robot_msgs.msg import Gear\nprint(Gear(), find('robots'))\n"
    )
    folder = prefixes["robots"] / "share" / "robots"
    assert simulate(package / "node.py", 0).console == f"robot_msgs.msg.Gear(number=3) {folder}\n"


def test_a_node_of_ros_2_finds_the_folders_of_packages(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """The packages of its workspace; a package has one folder, its source."""
    for name in ("mine", "other"):
        (tmp_path / "src" / name).mkdir(parents=True)
        (tmp_path / "src" / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
    node = tmp_path / "src" / "mine" / "node.py"
    node.write_text(
        "import rclpy\nfrom ament_index_python import get_package_share_path\n"
        "from ament_index_python.packages import PackageNotFoundError, get_package_share_directory as find\n"
        "print(find('mine'), get_package_share_path('other').name)\n"
        "for name in ('nobody', 'no package'):\n"
        "    try:\n        find(name)\n    except (PackageNotFoundError, ValueError) as error:\n        print(error)\n"
    )
    found, *errors = simulate(node, 0).console.splitlines()
    assert found == f"{node.parent} other"
    missing = f"package 'nobody' not found, searching: {[str(node.parent)]}"
    assert errors == [repr(missing), "'no package' is not a valid package name"]
    node.write_text(
        "import os, rclpy\nfrom ament_index_python import get_package_share_directory as find\n"
        f"os.chdir({str(tmp_path)!r})\nprint(find('mine'), __file__)\n"
    )
    monkeypatch.chdir(node.parent)  # Python makes __file__ an absolute path, too
    assert simulate("node.py", 0).console == f"{node.parent} {node}\n"
    node.write_text("import rclpy\nimport ament_index_python\nament_index_python.get_resource\n")
    with pytest.raises(NotSimulated, match=r"ament_index_python\.get_resource"):
        simulate(node, 0)


def test_a_file_is_main(write: Any) -> None:
    path = write("import __main__, sys\nx = 1\nprint(__name__, __file__ == sys.argv[0], __main__.x, sys.argv[1:])")
    assert simulate(path, 1, ["a", "_b:=c"]).console == "__main__ True 1 ['a', '_b:=c']\n"


def test_a_function_is_a_node_too() -> None:
    def my_node() -> None:
        import rospy  # type: ignore[import-not-found]

        assert rospy is rosspin.rospy
        assert sys.argv == ["my_node", "__ns:=/mrp"]
        rospy.init_node("node")
        print(rospy.get_name())

    assert simulate(my_node, 1, ["__ns:=/mrp"]).console == "/mrp/node\n"


def test_outside_of_a_run_there_is_no_node() -> None:
    for ask in (rospy.Time.now, rospy.get_name, rospy.is_shutdown):
        with pytest.raises(RuntimeError, match="^no node runs here: "):
            ask()


# --- what is no run ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("run", [simulate, measure])
@pytest.mark.parametrize("seconds", [-1, -0.001, math.nan, math.inf, "2", None])
def test_bad_seconds(run: Any, seconds: Any) -> None:
    with pytest.raises(ValueError, match="^seconds must be a number of at least 0, not "):
        run(lambda: None, seconds)


@pytest.mark.parametrize("run", [simulate, measure])
def test_bad_files(run: Any, write: Any) -> None:
    with pytest.raises(FileNotFoundError):
        run("no/such/file.py", 1)
    with pytest.raises(IsADirectoryError):
        run(Path(__file__).parent, 1)
    with pytest.raises(SyntaxError):
        run(write("def ("), 1)
    with pytest.raises(SyntaxError, match="null bytes"):
        run(write("x = 1\0"), 1)


def test_a_module_of_ros_is_not_simulated(write: Any) -> None:
    for module in ("control_srvs.srv", "cv_bridge", "my_robot_msgs.msg", "my_robot_interfaces.msg"):
        package = module.partition(".")[0]
        with pytest.raises(NotSimulated, match=rf"^{package}(\.msg)? is not simulated; run this node on a real ROS$"):
            simulate(write(f"import {module}"), 1)
    assert simulate(write("import no_such_module"), 1).status == 1


@pytest.mark.parametrize(
    ("ros", "modules"),
    [
        ("rospy", "dynamic_reconfigure.server image_geometry laser_geometry rosbag smach tf_conversions"),
        ("rclpy", "image_geometry launch_testing moveit.planning nav2_simple_commander.robot_navigator rosbag2_py"),
    ],
)
def test_packages_of_its_ros_are_not_simulated_and_those_of_the_other_are_not_there(
    write: Any, ros: str, modules: str
) -> None:
    for module in modules.split():
        with pytest.raises(NotSimulated, match=rf"^{module.partition('.')[0]} is not simulated"):
            simulate(write(f"import {ros}\nimport {module}"), 1)
    for other in {"rospy": ["rosbag2_py", "ros2cli"], "rclpy": ["rosbag", "dynamic_reconfigure"]}[ros]:
        run = simulate(write(f"import {ros}\nimport {other}"), 1)
        assert run.console.endswith(f"ModuleNotFoundError: No module named '{other}'\n")


def test_the_master_is_not_simulated_wherever_it_is_met() -> None:
    def in_a_callback() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(1), lambda event: rospy.MasterProxy())
        rospy.spin()

    for node in (lambda: rospy.MasterProxy(), in_a_callback):
        with pytest.raises(NotSimulated, match=r"^rospy\.MasterProxy is not simulated; run this node on a real ROS$"):
            simulate(node, 10)


def test_a_loop_that_sleeps_no_time_is_found_with_its_line(write: Any) -> None:
    path = write("import rospy\nrospy.init_node('n')\nwhile True: rospy.sleep(0)\n")
    with pytest.raises(TimeStandsStill, match=r"node\.py:3: simulated time stands still at 0\.0 s"):
        simulate(path, 10)


def test_a_timer_without_a_period_is_found_with_its_line(write: Any) -> None:
    path = write("import rospy\nrospy.init_node('n')\nrospy.Timer(rospy.Duration(-1), print)\nrospy.spin()\n")
    with pytest.raises(TimeStandsStill, match=r"node\.py:3: simulated time stands still"):
        simulate(path, 10)


def test_a_busy_callback_is_found_in_the_end(write: Any, watchful: None) -> None:
    path = write(
        """
        import rospy

        def callback(event):
            try:
                while True: pass
            except Exception:
                pass

        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), callback)
        rospy.spin()
        """
    )
    with pytest.raises(TimeStandsStill, match=r"node\.py:6: simulated time stands still at 0\.5 s"):
        simulate(path, 10)


def test_after_an_error_the_next_run_is_as_ever() -> None:
    with pytest.raises(NotSimulated):
        simulate(lambda: rospy.MasterProxy(), 1)
    assert simulate(TIMER_NODE, 2).console == NAMESPACE + counters(0.5, 1.0, 1.5, 2.0)


def test_ticks_are_recorded_only_if_asked_for() -> None:
    assert run_node(load(lambda: None), 1, (), Simulation()).ticks == ()


def test_randomness_is_the_node_s_own_affair() -> None:
    """A seeded node gives the same run every time, on any number of timers."""

    def node() -> None:
        numbers = random.Random(1)
        rospy.init_node("node")
        for _ in range(20):
            rospy.Timer(rospy.Duration(numbers.uniform(0.05, 0.5)), lambda event: rospy.sleep(numbers.uniform(0, 1)))
        rospy.spin()

    assert simulate(node, 5) == simulate(node, 5)


# --- the environment, several at once, and what is no node ------------------------------------------------------------


def test_what_a_node_sets_in_the_environment_ends_with_its_run() -> None:
    def node() -> None:
        os.environ["ROSCONSOLE_FORMAT"] = "${message}"

    simulate(node, 1)
    assert "ROSCONSOLE_FORMAT" not in os.environ


def test_runs_in_several_threads_take_turns() -> None:
    def node(word: str) -> Callable[[], None]:
        def main() -> None:
            for _ in range(200):
                print(word)

        return main

    consoles: dict[str, str] = {}
    words = ["a", "b", "c"]
    threads = [
        threading.Thread(target=lambda word=word: consoles.update({word: simulate(node(word), 1).console}))
        for word in words
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert consoles == {word: f"{word}\n" * 200 for word in words}


@pytest.mark.parametrize("run", [simulate, measure, lambda node, _, args: start(node, args)])
def test_a_command_line_is_in_words(run: Any) -> None:
    with pytest.raises(TypeError, match=r"args is a list of words, not a text: \['a:=b', 'c'\], not 'a:=b c'"):
        run(print, 0, "a:=b c")


@pytest.mark.parametrize("run", [simulate, measure, lambda node, _: start(node)])
def test_what_is_no_node(run: Any) -> None:
    with pytest.raises(TypeError, match="^a node is the path of a file, or a function, not 3$"):
        run(3, 0)


def test_a_node_may_import_its_own_package(write: Any, tmp_path: Path) -> None:
    """As after a build: the one for the folder in which it is."""
    (tmp_path / "pkg").mkdir()
    write("", "pkg/__init__.py")
    write("value = 1", "pkg/helper.py")
    path = write("from pkg.helper import value\nprint(value)", "pkg/node.py")
    for value in (1, 2):
        write(f"value = {value}", "pkg/helper.py")
        os.utime(path.parent / "helper.py", (value, value))
        assert simulate(path, 1).console == f"{value}\n"


@pytest.mark.parametrize("several", [False, True])
def test_a_node_imports_what_lies_beside_it_though_its_caller_has_a_module_of_that_name(
    several: bool, write: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for folder in ("node", "test"):
        (tmp_path / folder / "shared").mkdir(parents=True)
        write(f"whose = '{folder}'", f"{folder}/helper_of_somebody.py")
        write("", f"{folder}/shared/__init__.py")
        write(f"whose = '{folder}'", f"{folder}/shared/part.py")
    path = write(
        "import helper_of_somebody, shared.part\nprint(helper_of_somebody.whose, shared.part.whose)", "node/n.py"
    )
    monkeypatch.syspath_prepend(tmp_path / "test")
    caller = [import_module(name) for name in ("helper_of_somebody", "shared.part")]
    said = simulate([path, path] if several else path, 1).console
    assert said.count("node node\n") == 1 + several and "test" not in said.replace(str(tmp_path), "")
    assert [sys.modules[module.__name__] for module in caller] == caller
    for module in (*caller, sys.modules["shared"]):
        monkeypatch.delitem(sys.modules, module.__name__)


# --- what only a real ROS, or another clock, has ----------------------------------------------------------------------

PROCESSES = {
    "multiprocessing.Process": "multiprocessing.get_context(METHOD).Process(target=print).start()",
    "multiprocessing.Pool": "multiprocessing.get_context(METHOD).Pool(2)",
    "multiprocessing.Manager": "multiprocessing.get_context(METHOD).Manager()",
    "ProcessPoolExecutor": "futures.ProcessPoolExecutor(2, multiprocessing.get_context(METHOD)).submit(pow, 2, 3)",
}


@pytest.mark.parametrize("name", PROCESSES)
@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
@pytest.mark.parametrize("where", ["main", "thread"])
def test_a_process_of_a_node_in_simulated_time_is_named(write: Any, name: str, method: str, where: str) -> None:
    starts = PROCESSES[name].replace("METHOD", repr(method))
    node = write(
        f"""
        import concurrent.futures as futures, multiprocessing, rospy, threading
        rospy.init_node("node")
        def work():
            {starts}
        {"work()" if where == "main" else "threading.Thread(target=work).start()"}
        rospy.spin()
        """
    )
    with pytest.raises(NotSimulated) as caught:
        simulate(node, 5)
    on = "the wall clock or on a real ROS" if method == "fork" else "a real ROS"
    assert say_error(caught.value) == f"{node}:5: {name} ({method}) is not simulated; run this node on {on}"
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args


def test_a_node_can_do_without_a_package_of_ros(write: Any) -> None:
    node = write("import rospy\ntry:\n    import cv_bridge\nexcept ImportError:\n    print('without')\n")
    assert simulate(node, 1).console == "without\n"


# --- what a node does to its surroundings -----------------------------------------------------------------------------


def test_a_run_can_begin_in_a_folder_that_was_removed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "folder"
    folder.mkdir()
    monkeypatch.chdir(folder)
    folder.rmdir()
    assert simulate(lambda: print("here"), 1).console == "here\n"


def test_a_null_byte_is_shown_in_its_file_and_line(write: Any) -> None:
    path = write("x = 1\n\n\0")
    with pytest.raises(SyntaxError) as caught:
        simulate(path, 1)
    assert say_error(caught.value).startswith(f'File "{path}", line 3\n')


def test_a_neighbour_of_another_python_is_none_of_our_business_until_it_is_imported(write: Any) -> None:
    write("print 1\n", "legacy.py")
    path = write("import types, rospy\nprint(types.SimpleNamespace(legacy=rospy.Duration(1).to_sec()).legacy)\n")
    assert simulate(path, 1).console == "1.0\n"
    run = simulate(write("import legacy\n"), 1)
    assert run.status == 1 and 'legacy.py", line 1\n' in run.console


def test_a_signal_cannot_be_blocked_in_simulated_time() -> None:
    run = simulate(lambda: signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT}), 1)
    assert "signal.pthread_sigmask is not simulated; run this node on the wall clock\n" in run.console
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


def test_the_time_since_logging_began_is_simulated() -> None:
    def node() -> None:
        logging.basicConfig(format="%(relativeCreated)d %(message)s", stream=sys.stdout, force=True)
        time.sleep(2.5)
        logging.warning("text")

    assert simulate(node, 5).console == "2500 text\n"
    record = logging.LogRecord("name", 0, "", 0, "", None, None)
    assert 0 < record.relativeCreated < 1e9


# --- files in the way -------------------------------------------------------------------------------------------------


def test_a_file_in_the_way_is_named_in_steps_too(write: Any) -> None:
    write("", "random.py")
    with start(write("import rospy, random\nprint(random.Random)\n")) as node:
        node.advance(1)
    said, text = node.run.console.splitlines()
    assert said.startswith("rosspin: ") and "random.py is in the way of Python's module random" in said
    assert text == "<class 'random.Random'>"


def test_a_node_may_itself_be_in_the_way(write: Any) -> None:
    node = write("import rclpy\n", "rclpy.py")
    assert "rclpy.py is in the way of ROS 2's module rclpy" in simulate(node, 1).console
    assert "rclpy.py is in the way of ROS 2's module rclpy" not in simulate(write("print(1)\n"), 1).console


def test_what_cannot_be_in_the_way_is_passed_over(write: Any) -> None:
    for name in ("sys.py", "os.py", "rclpy.py", "geometry_msgs.py", "helper.py", "not-a-name.py"):
        write("", name)
    assert simulate(write("import rospy, helper\n"), 1).console == ""


def test_ctrl_c_of_the_user_ends_a_simulated_run() -> None:
    begun = threading.Event()

    def node() -> None:
        begun.set()
        while True:
            time.sleep(1)

    def press() -> None:
        begun.wait()
        os.kill(os.getpid(), signal.SIGINT)

    user = threading.Thread(target=press)
    user.start()
    with pytest.raises(KeyboardInterrupt):
        simulate(node, 1e9)
    user.join()


# --- when the clocks begin --------------------------------------------------------------------------------------------


def _asks_for_a_second_ago() -> None:
    rospy.init_node("node")
    print(rospy.Time.now() - rospy.Duration(1) > rospy.Time(0))


def test_clocks_begin_where_the_caller_says() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(0.5), lambda event: print(rospy.Time.now().to_sec(), time.time()))
        rospy.spin()

    run = simulate(node, 1, start=1.7e9)
    assert run.console == "1700000000.5 1700000000.5\n1700000001.0 1700000001.0\n"
    assert [(tick.expected, tick.real) for tick in run.ticks] == [(0.5, 0.5), (1.0, 1.0)]
    assert (run.start, run.seconds) == (1.7e9, 1)
    assert simulate([node], 1, start=1.7e9).ticks[0].expected == 0.5
    for begin in (-1, math.nan, "1"):
        with pytest.raises(ValueError, match="^start must be a number of at least 0, not "):
            simulate(node, 1, start=begin)  # type: ignore[arg-type]


def test_a_time_before_the_beginning_is_an_error_with_a_hint() -> None:
    run = simulate(_asks_for_a_second_ago, 1)
    assert run.status == 1
    assert "TypeError: time values must be positive\nrosspin: simulated clocks begin at 0" in run.console
    assert simulate(_asks_for_a_second_ago, 1, start=2.0).console == "True\n"


def test_a_time_before_the_beginning_has_a_hint_in_ros2() -> None:
    def node() -> None:
        import rclpy  # type: ignore[import-not-found]
        from rclpy.duration import Duration  # type: ignore[import-not-found]

        rclpy.init()
        print(rclpy.create_node("node").get_clock().now() - Duration(seconds=1) is not None)

    run = simulate(node, 1)
    assert "ValueError: Subtraction leads to negative time.\nrosspin: simulated clocks begin at 0" in run.console
    assert simulate(node, 1, start=1.7e9).console == "True\n"
