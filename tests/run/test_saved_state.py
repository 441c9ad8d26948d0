"""What one node does to the modules and the process is gone with its run."""

from __future__ import annotations

import asyncio
import builtins
import gc
import json
import os
import random
import subprocess
import sys
import threading
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import rosspin
from rosspin import Run, rospy, simulate
from rosspin.run.host import replaced
from rosspin.run.saved_state import SAVED

_REFERENCE = {
    1: """
        import builtins, decimal, gc, logging, math, os, queue, random, sys, threading, time, warnings
        import rospy
        from rospy import Duration, Rate, Time
        from std_msgs.msg import Header, String

        rospy.init_node("node")
        publisher = rospy.Publisher("topic", String, queue_size=1)
        rospy.Subscriber("topic", String, lambda message: print("heard", message.data, time.time()))
        rospy.Timer(Duration(0.3), lambda event: print("timer", rospy.get_time(), event.current_real.to_sec()))
        print(Header(), String(), String.__slots__, rospy.Time(1) - Time(0.5), Duration(1) * 2, sorted(vars(String)))
        print(sorted(rospy.NOT_SIMULATED), hasattr(rospy, "new"), hasattr(builtins, "new"))
        rate = Rate(5)
        while not rospy.is_shutdown():
            publisher.publish(f"{rospy.get_time()}")
            rospy.loginfo("%s", len(threading.enumerate()))
            rate.sleep()
        """,
    2: """
        import builtins, decimal, gc, logging, math, os, queue, random, sys, threading, time, warnings
        import rclpy
        from rclpy.duration import Duration
        from rclpy.node import Node
        from rclpy.qos import qos_profile_sensor_data
        from std_msgs.msg import Header, String

        rclpy.init()
        node = Node("node")
        publisher = node.create_publisher(String, "topic", qos_profile_sensor_data)
        node.create_subscription(String, "topic", lambda message: print("heard", message.data, time.time()), 10)
        print(Header(), String(), sorted(vars(String)), Duration(seconds=1), qos_profile_sensor_data.depth)
        print(len(vars(Node)), hasattr(rclpy, "new"), hasattr(builtins, "new"), rclpy.node.Node is Node)

        def callback():
            publisher.publish(String(data=str(node.get_clock().now().nanoseconds)))
            node.get_logger().info(str(len(threading.enumerate())))

        node.create_timer(0.3, callback)
        rclpy.spin(node)
        """,
}

_OF_BOTH = [
    "import builtins; builtins.print = lambda *words: None",
    "import builtins; builtins.open = builtins.sorted = None",
    "import builtins; del builtins.len",
    "import builtins; builtins.new = 1",
    "import builtins; builtins.next = builtins.isinstance = builtins.list = None",
    "import gc; gc.disable(); gc.set_threshold(1); gc.callbacks.append(lambda *words: None)",
    "import gc; gc.set_debug(gc.DEBUG_SAVEALL)",
    "import sys; sys.setswitchinterval(5); sys.setrecursionlimit(300)",
    "import sys; sys.stdout = sys.stderr = None",
    "import sys; sys.argv = 1; sys.exit = sys.getsizeof = None",
    "import sys; sys.path.clear(); sys.path_hooks.clear()",
    "import sys; sys.modules['time'] = sys.modules['json'] = sys.modules['unheard_of'] = 1",
    "import sys; sys.modules['rospy'] = sys.modules['rclpy'] = 1",
    "import sys; del sys.modules['threading'], sys.modules['math']",
    "import sys; sys.settrace(lambda *words: None); sys.setprofile(lambda *words: None)",
    "import sys; sys.excepthook = sys.displayhook = None",
    "import threading; threading.settrace(lambda *words: None); threading.excepthook = None",
    "import threading; threading.Thread = threading.Event = threading.Lock = None",
    "import threading; threading.Thread.start = lambda self: None",
    "import threading; threading.stack_size(1 << 20)",
    "import time; time.sleep = time.time = time.monotonic = time.strftime = None",
    "import time, os; os.environ['TZ'] = 'Asia/Tokyo'; time.tzset()",
    "import os; os.environ.clear(); os.chdir('/'); os.umask(0); os.getpid = None",
    "import os; os.environ = {}",
    "import random; random.seed(1); random.random = lambda: 4",
    "import random; random.shuffle(list(range(10)))",
    "import math; math.pi = 3; del math.floor",
    "import queue; queue.Queue.put = None; queue.deque = None",
    "import logging; logging.disable(); logging.Logger.info = None; logging.root.handlers.append(1)",
    "import warnings; warnings.filterwarnings('error'); warnings.showwarning = None",
    "import decimal; decimal.getcontext().prec = 2; decimal.setcontext(decimal.Context(prec=1))",
    "import locale; locale.setlocale(locale.LC_ALL, 'C')",
    "import socket; socket.setdefaulttimeout(0.1)",
    "import signal; signal.signal(signal.SIGTERM, signal.SIG_IGN); signal.signal = None",
    "import std_msgs.msg; std_msgs.msg.String = 1; std_msgs.msg.Header.x = 1",
    "import std_msgs.msg; std_msgs.msg.String.__init__ = std_msgs.msg.String.__repr__ = None",
    "import std_msgs.msg; std_msgs.msg.String.__slots__.append('x')",
    "import std_msgs.msg; std_msgs.msg.String.__mro__[1].x = 1",
]
_OF = {
    1: [
        *_OF_BOTH,
        "rospy.Duration = 0.1",
        "del rospy.Rate, rospy.Time",
        "rospy.Rate.sleep = lambda self: None",
        "rospy.new = 1; rospy.core.new = 2; rospy.Timer.new = 3",
        "rospy.rostime.Time.now = rospy.Time.from_sec = None",
        "rospy.timer.Duration = rospy.rostime.Duration = None",
        "rospy.Time.__bases__[0].__sub__ = None",
        "rospy.MODULES.clear(); rospy.NOT_SIMULATED.add('Rate')",
        "rospy.Publisher.publish = rospy.topics.Subscriber = None",
        "rospy.init_node = rospy.loginfo = rospy.get_time = print",
        "rospy.Time.__slots__.append('x'); rospy.Time._slot_types.clear()",
    ],
    2: [
        *_OF_BOTH,
        "rclpy.init = 1; del rclpy.spin",
        "rclpy.new = 1; import rclpy.node; rclpy.node.Node.foo = 1; rclpy.node.new = 2",
        "import rclpy.node; rclpy.node.Node.create_timer = rclpy.node.Node = None",
        "import rclpy.qos; rclpy.qos.qos_profile_sensor_data.depth = 77; rclpy.qos.QoSProfile.x = 1",
        "import rclpy.duration; rclpy.duration.Duration.__init__ = None; rclpy.duration.Infinite.x = 1",
        "import rclpy.timer; rclpy.timer.Rate.sleep = rclpy.timer.Timer.cancel = None",
        "import rclpy.logging; rclpy.logging.LoggingSeverity.INFO._value_ = 1; rclpy.logging.get_logger = None",
        "rclpy.__path__.append('x'); rclpy.__dict__.clear()",
        "import rclpy.executors; rclpy.executors.SingleThreadedExecutor.spin = None",
    ],
}
CHANGES = [pytest.param(ros, change, id=f"ros{ros} {change}") for ros in (1, 2) for change in _OF[ros]]
_BEGIN = {1: "import rospy\n", 2: "import rclpy\n"}


@pytest.fixture(scope="module")
def references(tmp_path_factory: pytest.TempPathFactory) -> dict[int, tuple[str, list[Any]]]:
    """The path of each ROS's reference node, and what it gives in a fresh process."""
    folder = tmp_path_factory.mktemp("references")
    program = (
        f"import json, rosspin; {_told.__name__} = lambda run: [run.status, run.console, list(map(list, run.ticks))]"
    )
    found = {}
    for ros, text in _REFERENCE.items():
        path = folder / f"ros{ros}.py"
        path.write_text(dedent(text))
        words = [sys.executable, "-c", f"{program}; print(json.dumps(_told(rosspin.simulate({str(path)!r}, 2))))"]
        found[ros] = str(path), json.loads(subprocess.run(words, check=True, capture_output=True).stdout)
    return found


def _told(run: Run) -> list[Any]:
    return [run.status, run.console, [list(tick) for tick in run.ticks]]


def spoil(folder: Path, ros: int, *changes: str) -> None:
    """Run a node that makes these changes. What becomes of it does not matter."""
    path = folder / f"spoiler{ros}.py"
    path.write_text(_BEGIN[ros] + "".join(f"try:\n    {each}\nexcept AttributeError: pass\n" for each in changes))
    try:
        simulate(str(path), 0.5)
    except Exception:
        pass


@pytest.mark.parametrize(("ros", "change"), CHANGES)
def test_what_a_node_changes_is_gone_with_its_run(ros: int, change: str, references: Any, tmp_path: Path) -> None:
    path, expected = references[ros]
    environment, folder, state = dict(os.environ), os.getcwd(), random.getstate()
    of_gc = gc.isenabled(), gc.get_threshold(), gc.get_debug(), gc.callbacks[:]
    of_sys = sys.getswitchinterval(), sys.getrecursionlimit(), sys.gettrace(), sys.getprofile(), sys.path[:]
    names = vars(builtins).copy()
    spoil(tmp_path, ros, change)
    assert vars(builtins) == names
    assert of_gc == (gc.isenabled(), gc.get_threshold(), gc.get_debug(), gc.callbacks[:])
    assert of_sys == (sys.getswitchinterval(), sys.getrecursionlimit(), sys.gettrace(), sys.getprofile(), sys.path[:])
    assert (environment, folder, state) == (dict(os.environ), os.getcwd(), random.getstate())
    assert "unheard_of" not in sys.modules and sys.modules["threading"] is threading
    assert not {"rospy", "rclpy", "std_msgs.msg"} & sys.modules.keys()
    assert _told(simulate(path, 2)) == expected


@settings(max_examples=10, deadline=None)
@given(data=st.data())
@pytest.mark.parametrize("ros", [1, 2])
def test_so_is_all_of_it_together(ros: int, references: Any, tmp_path_factory: Any, data: st.DataObject) -> None:
    path, expected = references[ros]
    changes = data.draw(st.lists(st.sampled_from(_OF[ros]), min_size=1, max_size=6))
    spoil(tmp_path_factory.mktemp("spoilers"), ros, *changes)
    assert _told(simulate(path, 2)) == expected


@pytest.mark.parametrize("ros", [1, 2])
def test_a_node_can_import_what_it_has_made_up(ros: int, tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    made_up = "import sys\nfrom unittest.mock import MagicMock\nsys.modules['cv2'] = MagicMock()\n"
    path.write_text(f"{_BEGIN[ros]}{made_up}import cv2\nprint(cv2 is sys.modules['cv2'])\n")
    run = simulate(str(path), 1)
    assert (run.status, run.console) == (0, "True\n")
    assert "cv2" not in sys.modules


def test_during_the_run_the_node_sees_its_own_changes() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.Rate.sleep = lambda self: print("mine")  # type: ignore[method-assign]
        builtins.mine = "everywhere"  # type: ignore[attr-defined]
        rospy.Rate(1).sleep()
        thread = threading.Thread(target=lambda: print(mine))  # type: ignore[name-defined]  # noqa: F821
        thread.start()

    assert simulate(node, 5).console == "mine\neverywhere\n"
    assert not hasattr(builtins, "mine")


def test_a_started_node_finds_its_changes_again_and_the_test_does_not() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.mine = 1
        rospy.Duration.mine = 2  # type: ignore[attr-defined]
        builtins.mine = 3  # type: ignore[attr-defined]
        random.seed(7)
        rospy.sleep(1)
        print(rospy.mine, rospy.Duration.mine, mine, random.random())  # type: ignore[attr-defined,name-defined]  # noqa: F821

    number = random.Random(7).random()
    before = random.getstate()
    with rosspin.start(node) as started:
        assert not hasattr(rospy, "mine") and not hasattr(rospy.Duration, "mine") and not hasattr(builtins, "mine")
        assert started.advance(2).console == f"1 2 3 {number}\n"
    assert not hasattr(rospy, "mine") and random.getstate() == before


def test_of_several_nodes_one_sees_what_another_has_changed_until_the_run_ends() -> None:
    def changes() -> None:
        rospy.init_node("changes")
        rospy.mine = 1
        rospy.spin()

    def looks() -> None:
        rospy.init_node("looks")
        rospy.sleep(1)
        print(rospy.mine)
        rospy.spin()

    assert "\n1\n" in "\n" + simulate([rosspin.Node(changes, name="a"), rosspin.Node(looks, name="b")], 2).console
    assert not hasattr(rospy, "mine")


def test_what_is_replaced_outside_of_a_run_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    def node() -> None:
        rospy.init_node("node")
        print(rospy.get_name())

    monkeypatch.setattr(rospy, "get_name", lambda: "replaced")
    assert [simulate(node, 1).console for _ in range(2)] == ["replaced\n"] * 2


def test_a_run_goes_on_with_the_numbers_of_who_starts_it() -> None:
    def node() -> None:
        print(random.random())

    random.seed(5)
    expected = random.random()
    random.seed(5)
    assert simulate(node, 1).console == f"{expected}\n"
    assert random.random() == expected


def test_the_list_of_what_is_kept_names_each_once() -> None:
    assert len({each.what for each in SAVED}) == len(SAVED)


def names_of_the_library() -> dict[tuple[str, str], Any]:
    """What the modules of the standard library and their classes hold now, by their names, except what sys holds."""
    found: dict[tuple[str, str], Any] = {}
    for name, module in list(sys.modules.items()):
        if name.partition(".")[0] in sys.stdlib_module_names - {"sys"}:
            places = [module, *(each for each in vars(module).values() if isinstance(each, type))]
            for place in places:
                own = place.__module__ if isinstance(place, type) else name
                where = f"{name}.{place.__qualname__}" if isinstance(place, type) else name
                found |= {(where, key): value for key, value in vars(place).items() if own == name}
    return found


@pytest.mark.parametrize("ros", ["rospy", "rclpy"])
def test_all_that_a_run_replaces_is_in_the_list_that_a_page_shows(ros: str, monkeypatch: pytest.MonkeyPatch) -> None:
    listed = {
        (f"{place.__module__}.{place.__qualname__}" if isinstance(place, type) else place.__name__, name)
        for place, name, _ in replaced()
    }
    during: dict[tuple[str, str], Any] = {}

    def node() -> None:
        __import__(ros)
        during.update(names_of_the_library())

    monkeypatch.setattr("asyncio.events._event_loop_policy", asyncio.DefaultEventLoopPolicy())
    before = names_of_the_library()
    simulate(node, 1)
    changed = {name for name, value in during.items() if name in before and value is not before[name]}
    assert len(changed) > 50
    # Each process has its own of these, and they are among what is kept.
    assert changed - listed <= {("warnings", "filters"), ("asyncio.events", "_event_loop_policy")}
