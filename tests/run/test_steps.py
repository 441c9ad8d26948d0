"""Nodes in steps: what a test does to them, what it sees of them, and that nothing of them is in its way."""

from __future__ import annotations

import cProfile
import logging
import os
import signal
import subprocess
import sys
import threading
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rosspin import NodeFailed, NotSimulated, TimeStandsStill, rospy, simulate, start
from tests.helpers.tree import SOURCE

# --- nodes ------------------------------------------------------------------------------------------------------------


def listener(kind: str = "UInt32", **options: Any) -> Callable[[], None]:
    """A node that prints what it hears on /a, and when."""

    def node() -> None:
        import std_msgs.msg

        rospy.init_node("listener")
        rospy.Subscriber("a", getattr(std_msgs.msg, kind), lambda heard: print(rospy.get_time(), heard), **options)
        rospy.spin()

    return node


def echo() -> None:
    """Answers on /b what it hears on /a."""
    from std_msgs.msg import UInt32

    rospy.init_node("echo")
    publisher = rospy.Publisher("b", UInt32, queue_size=1)
    rospy.Subscriber("a", UInt32, lambda heard: publisher.publish(heard.data))
    rospy.spin()


def failing(where: str) -> Callable[[], None]:
    """A node that fails 0.3 s after its start, and again each 0.3 s if it can."""

    def node() -> None:
        def fail(*_: object) -> None:
            raise ZeroDivisionError("broken")

        def work() -> None:
            rospy.sleep(0.3)
            fail()

        from std_msgs.msg import Empty

        rospy.init_node("failing")
        if where == "timer":
            rospy.Timer(rospy.Duration(0.3), fail)
        elif where == "callback":
            publisher = rospy.Publisher("tick", Empty, queue_size=1)
            rospy.Subscriber("tick", Empty, fail)
            rospy.Timer(rospy.Duration(0.3), lambda event: publisher.publish())
        elif where == "thread":
            threading.Thread(target=work).start()
        elif where == "main":
            work()
        rospy.spin()

    return node


# --- publishing to it -------------------------------------------------------------------------------------------------


def test_a_message_arrives_at_once_in_the_next_step() -> None:
    with start(listener()) as node:
        node.publish("/a", data=1)
        assert node.run.console == ""
        assert node.advance(0).console == "0.0 data: 1\n"
        node.advance(0.7)
        node.publish("/a", data=2)
        assert node.advance(1).console == "0.7 data: 2\n"


def test_all_messages_of_an_instant_arrive_in_order() -> None:
    with start(listener()) as node:
        for number in range(5):
            node.publish("/a", number)
        assert node.advance(0).console == "".join(f"0.0 data: {number}\n" for number in range(5))


def test_a_full_queue_drops_the_oldest() -> None:
    with start(listener(queue_size=2)) as node:
        for number in range(5):
            node.publish("/a", number)
        assert node.advance(0).console == "0.0 data: 3\n0.0 data: 4\n"


def test_a_message_is_given_by_name_by_position_or_whole() -> None:
    class Real:  # as of a real ROS: another class with the same sum
        _type, _has_header, _md5sum = "std_msgs/UInt32", False, "304a39449588c7f8ce2df6e8001c5fce"

        def serialize(self, buff: Any) -> None:
            buff.write(b"\x04\0\0\0")

    with start(listener()) as node:
        node.publish("/a", data=1)
        node.publish("a", 2)
        node.publish("/a", node.message("std_msgs/UInt32", data=3))
        node.publish("/a", Real())
        node.publish("/a")
        assert node.advance(0).console == "".join(f"0.0 data: {number}\n" for number in (1, 2, 3, 4, 0))


def test_dicts_stand_for_nested_messages_and_numbers_for_times() -> None:
    def node_function() -> None:
        from nav_msgs.msg import Path as Way

        rospy.init_node("n")
        rospy.Subscriber("way", Way, heard.append)
        rospy.spin()

    heard: list[Any] = []
    with start(node_function) as node:
        node.advance(1.3)
        pose = {"header": {"stamp": {"secs": 1, "nsecs": 5}}, "pose": {"position": {"x": 2.0}}}
        node.publish("way", header={"stamp": node.time, "frame_id": "map"}, poses=[pose, {}])
        node.advance(0)
    (way,) = heard
    assert way.header.stamp.to_nsec() == 1_300_000_000
    assert way.header.frame_id == "map"
    assert way.poses[0].header.stamp.to_nsec() == 1_000_000_005
    assert [pose.pose.position.x for pose in way.poses] == [2.0, 0.0]


def test_messages_of_the_node_s_own_package(tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    (tmp_path / "package.xml").write_text("<package><name>my_robot</name></package>")
    (tmp_path / "msg/Wheel.msg").write_text("float32[2] speeds\n")
    (tmp_path / "node.py").write_text(
        "import rospy\nfrom my_robot.msg import Wheel\nrospy.init_node('n')\n"
        "rospy.Subscriber('wheel', Wheel, lambda wheel: print(wheel.speeds))\nrospy.spin()\n"
    )
    with start(tmp_path / "node.py") as node:
        node.publish("/wheel", speeds=[0.5, 1.5])
        node.publish("/wheel", node.message("my_robot/Wheel", speeds=[2.5, 3.5]))
        assert node.advance(0).console == "(0.5, 1.5)\n(2.5, 3.5)\n"
        assert "my_robot" not in sys.modules


def test_what_cannot_be_published_is_the_test_s_error_and_breaks_nothing() -> None:
    with start(listener()) as node:
        with pytest.raises(LookupError, match=r"no node subscribes to /b; subscribed to are: /a \(std_msgs/UInt32\)"):
            node.publish("b", data=1)
        with pytest.raises(AttributeError, match="foo is not an attribute of UInt32"):
            node.publish("a", foo=1)
        with pytest.raises(TypeError, match="Invalid number of arguments"):
            node.publish("a", 1, 2)
        with pytest.raises(rospy.ROSSerializationException, match="field data must be unsigned integer type"):
            node.publish("a", data=-1)
        with pytest.raises(TypeError, match=r"expected \[uint32\] but got \[std_msgs/Int32\]"):
            node.publish("a", node.message("std_msgs/Int32", data=1))
        with pytest.raises(LookupError, match="there is no message std_msgs/Nonsense"):
            node.message("std_msgs/Nonsense")
        node.publish("a", data=1)
        assert node.advance(0).console == "0.0 data: 1\n"


def test_a_subscriber_of_any_type_takes_whole_messages() -> None:
    def node_function() -> None:
        rospy.init_node("n")
        rospy.Subscriber("a", rospy.AnyMsg, lambda message: print(message._connection_header["type"], message._buff))
        rospy.spin()

    with start(node_function) as node:
        with pytest.raises(TypeError, match="publish a whole message"):
            node.publish("a", data=1)
        node.publish("a", node.message("std_msgs/UInt8", data=7))
        assert node.advance(0).console == "std_msgs/UInt8 b'\\x07'\n"


def test_a_topic_that_is_subscribed_to_for_a_while_is_connected_as_long() -> None:
    def node_function() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("n")
        rospy.sleep(1)
        print(rospy.wait_for_message("a", UInt32))
        rospy.spin()

    with start(node_function) as node:
        with pytest.raises(LookupError, match="subscribed to are: none"):
            node.publish("a", 1)
        node.advance(1)
        node.publish("a", 1)
        assert node.advance(1).console == "data: 1\n"
        with pytest.raises(LookupError, match="subscribed to are: none"):
            node.publish("a", 2)


def test_the_test_is_connected_to_every_topic_from_the_start() -> None:
    def node_function() -> None:
        from std_msgs.msg import UInt32

        class Listener(rospy.SubscribeListener):
            def peer_subscribe(self, topic_name: str, topic_publish: Any, peer_publish: Any) -> None:
                print("comes", topic_name)

        rospy.init_node("n")
        publisher = rospy.Publisher("a", UInt32, Listener(), queue_size=1)
        subscriber = rospy.Subscriber("b", UInt32)
        print(publisher.get_num_connections())
        publisher.publish(1)
        rospy.sleep(0)
        print(subscriber.get_num_connections(), rospy.get_published_topics())

    with start(node_function) as node:
        assert node.run.console == "comes /a\n1\n1 [['/rosout', 'rosgraph_msgs/Log'], ['/a', 'std_msgs/UInt32']]\n"


def test_values_that_the_node_publishes_are_checked() -> None:
    def node_function() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("n")
        rospy.Publisher("a", UInt32, queue_size=1).publish(-1)

    with pytest.raises(rospy.ROSSerializationException, match="unsigned integer"):
        start(node_function)


def test_parameters_and_arguments() -> None:
    def node_function() -> None:
        rospy.init_node("n")
        print(*(rospy.get_param(name) for name in ("/robot/name", "~rate", "~gain", "speed")), rospy.get_name())

    parameters = {"/robot": {"name": "Ada"}, "~rate": 50, "~gain": 1, "speed": 2}
    with start(node_function, ["__name:=m", "_gain:=3"], parameters) as node:
        assert node.run.console == "Ada 50 3 2 /m\n"


# --- looking at it ----------------------------------------------------------------------------------------------------


def test_each_step_tells_what_happened_in_it() -> None:
    def node_function() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("n")
        publisher = rospy.Publisher("count", UInt32, queue_size=1)

        def tick(event: Any) -> None:
            publisher.publish(round(rospy.get_time() * 10))
            rospy.loginfo("tick")

        rospy.Timer(rospy.Duration(0.5), tick)
        rospy.spin()

    with start(node_function) as node:
        runs = [node.advance(0.6) for _ in range(3)]
        assert [[tick.real for tick in run.ticks] for run in runs] == [[0.5], [1.0], [1.5]]
        assert [[(sent.time, sent.message.data) for sent in run.messages] for run in runs] == [
            [(0.5, 5)],
            [(1.0, 10)],
            [(1.5, 15)],
        ]
        assert [run.console for run in runs] == [f"[INFO] [{when:.6f}]: tick\n" for when in (0.5, 1.0, 1.5)]
        assert [run.seconds for run in runs] == [0.6] * 3
        assert [(run.runtime, run.status) for run in runs] == [("simulated", 0)] * 3
        assert node.time == pytest.approx(1.8)
        assert node.run.console == "".join(run.console for run in runs)
        assert [*node.run.messages] == [sent for run in runs for sent in run.messages] == node.messages("count")
        assert node.status is None
    assert node.status == node.run.status == 0


def test_the_messages_of_a_topic() -> None:
    with start(echo) as node:
        assert node.messages("/b") == []
        for number in (1, 2):
            node.publish("/a", number)
            node.advance(0.1)
        assert [(sent.topic, sent.node, sent.time, sent.message.data) for sent in node.messages("/b")] == [
            ("/b", "/echo", 0.0, 1),
            ("/b", "/echo", 0.1, 2),
        ]
        assert node.messages("b")[-1].message == node.message("std_msgs/UInt32", data=2)
        assert {sent.topic for sent in node.run.messages} == {"/b"}  # the test's own are none of the node's
        with pytest.raises(LookupError, match=r"no node publishes /c; published are: /b \(std_msgs/UInt32\)"):
            node.messages("/c")
    assert len(node.messages("/b")) == 2


def asker() -> None:
    """Says what /drive is told; once /open is there, asks it, and again 1 s after each answer."""
    from std_srvs.srv import SetBool, Trigger  # type: ignore[import-not-found]

    rospy.init_node("asker")
    rospy.Service("drive", SetBool, lambda request: (request.data, f"drives: {request.data}"))
    proxy = rospy.ServiceProxy("open", Trigger)
    try:
        proxy.wait_for_service()
    except rospy.ROSInterruptException:
        return
    while not rospy.is_shutdown():
        try:
            success = proxy().success
            print(rospy.get_time(), success)
        except rospy.ServiceException as error:
            print(rospy.get_time(), error)
        rospy.sleep(1.0)


def test_a_service_is_called_in_the_next_step() -> None:
    with start(asker) as node:
        node.call("drive", data=True)
        node.call("/drive", False)
        assert not node.run.calls
        run = node.advance(0)
        assert [call.response.message for call in run.calls] == ["drives: True", "drives: False"]
        assert {call[:3] + call[4:6] for call in run.calls} == {("/drive", "/tester", 0.0, "/asker", 0.0)}
        assert not node.advance(0.5).calls


def test_a_test_offers_a_service() -> None:
    """Its function takes simulated time, and may give no response, which is an error."""
    answers = iter([True, None, False])

    def answer(request: Any) -> dict[str, Any] | None:
        time.sleep(0.25)
        success = next(answers)
        return None if success is None else {"success": success}

    with start(asker) as node:
        node.serve("/open", "std_srvs/Trigger", answer)
        run = node.advance(3)
        last = (
            "service [/open] responded with an error: b'service cannot process request: service handler returned None'"
        )
        # It needs 3 ms to find the service, each time that it looks or asks.
        assert run.console == f"0.256 True\n1.509 {last}\n2.762 False\n"
        assert [call[:3] + call[4:6] for call in run.calls][:2] == [
            ("/open", "/asker", 0.006, "/tester", 0.256),
            ("/open", "/asker", 1.259, "/tester", 1.509),
        ]


def test_an_error_in_a_service_of_the_test_is_the_test_s() -> None:
    node = start(asker)
    node.serve("open", "std_srvs/Trigger", lambda request: 1 // 0)  # type: ignore[arg-type, return-value]
    with pytest.raises(ZeroDivisionError) as raised:
        node.advance(1)
    files = {Path(frame.filename).name for frame in traceback.extract_tb(raised.value.__traceback__)}
    assert files == {"test_steps.py", "steps.py"}


def test_wrong_calls_are_errors_and_do_nothing() -> None:
    with start(asker) as node:
        with pytest.raises(LookupError, match=r"no node offers /drvie; offered are: /drive \(std_srvs/SetBool\)"):
            node.call("drvie")
        with pytest.raises(AttributeError, match="date"):
            node.call("drive", date=True)
        with pytest.raises(rospy.ROSSerializationException):
            node.call("drive", data="yes")
        with pytest.raises(LookupError, match="there is no service std_srvs/Nothing"):
            node.serve("open", "std_srvs/Nothing", lambda request: None)
        with pytest.raises(LookupError, match="only ROS 2's are simulated"):
            node.send_goal("drive", order=3)
        assert not node.advance(0.5).calls


def test_time_goes_on_after_the_node_s_own_end() -> None:
    def node_function() -> None:
        rospy.init_node("n")
        rospy.sleep(0.5)

    with start(node_function) as node:
        assert node.advance(0.4).status == 0
        assert node.status is None
        node.advance(1)
        assert [node.status, node.time] == [0, 1.4]
        node.advance(1)
        assert node.time == 2.4


@pytest.mark.parametrize("seconds", [-1, float("nan"), float("inf"), "1", 10**12])
def test_no_length_of_a_step(seconds: Any) -> None:
    with start(listener()) as node:
        with pytest.raises(ValueError, match="seconds must be"):
            node.advance(seconds)
        node.advance(1)


# --- what goes wrong in it --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("where", ["main", "timer", "callback", "thread"])
def test_an_exception_is_raised_in_the_step_that_ran_into_it(where: str) -> None:
    with start(failing(where)) as node:
        node.advance(0.2)
        with pytest.raises(ZeroDivisionError, match="broken") as caught:
            node.advance(2)
        assert node.time == pytest.approx(0.3)
        assert caught.value.__notes__ == ["raised in node at 0.3 s"]
        frames = [frame.name for frame in traceback.extract_tb(caught.tb)]
        assert frames[:3] == [frames[0], "advance", "_step"]  # the last two are hidden by pytest
        assert frames[-1] == "fail"
        assert not [each for each in traceback.extract_tb(caught.tb)[3:] if Path(each.filename).is_relative_to(SOURCE)]
        assert [entry.name for entry in caught.traceback if not entry.ishidden(None)][1:] == frames[3:]
        if where == "callback":  # it is called again
            with pytest.raises(ZeroDivisionError):
                node.advance(2)
            assert node.time == pytest.approx(0.6)
        elif where == "main":
            assert node.status == 1
        else:
            node.advance(2)
    assert "ZeroDivisionError: broken" in node.run.console


def test_of_two_exceptions_at_one_time_the_first_is_raised() -> None:
    def node_function() -> None:
        rospy.init_node("n")
        for _ in range(2):
            rospy.Timer(rospy.Duration(0.5), lambda event: int("fast"))
        rospy.spin()

    with start(node_function) as node:
        with pytest.raises(ValueError, match="fast") as caught:
            node.advance(1)
        assert [note[:25] for note in caught.value.__notes__[1:]] == ["then there was ValueError"]
        node.advance(1)


@pytest.mark.parametrize(("text", "error"), [("1 / 0", ZeroDivisionError), ("import nonsense", ModuleNotFoundError)])
def test_an_exception_at_the_start(write: Any, text: str, error: type[Exception]) -> None:
    with pytest.raises(error) as caught:
        start(write(f"import rospy\n{text}\n"))
    assert traceback.extract_tb(caught.tb)[-1].line == text


def test_what_cannot_be_started(write: Any, tmp_path: Path) -> None:
    with pytest.raises(OSError, match="none.py"):
        start(tmp_path / "none.py")
    with pytest.raises(SyntaxError):
        start(write("1 +"))
    with pytest.raises(NotSimulated, match="control_srvs"):
        start(write("import control_srvs.srv"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("sys.exit(3)", "node.py ended with status 3 at 0.5 s\nwhat I have said"),
        ("sys.exit('no laser')", "node.py ended with status 1 at 0.5 s\nwhat I have said\nno laser"),
        ("os._exit(4)", "node.py ended with status 4 at 0.5 s\nwhat I have said"),
        ("os.kill(os.getpid(), 10)", "node.py ended with status 138 at 0.5 s\nwhat I have said"),
    ],
)
def test_a_status_other_than_0_is_an_error(write: Any, text: str, message: str) -> None:
    node = start(
        write(f"import os, rospy, sys\nrospy.init_node('n')\nprint('what I have said')\nrospy.sleep(.5)\n{text}")
    )
    with pytest.raises(NodeFailed) as caught:
        node.advance(2)
    assert str(caught.value) == message
    assert node.time == 0.5
    node.advance(1)
    node.close()


def test_sys_exit_0_is_none(write: Any) -> None:
    with start(write("import rospy, sys\nrospy.init_node('n')\nrospy.sleep(.5)\nsys.exit(0)")) as node:
        node.advance(1)
        assert node.status == 0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("rospy.on_shutdown(lambda: [][0])\nrospy.spin()", "IndexError: list index out of range"),
        ("rospy.spin()\nsys.exit(3)", "NodeFailed: node.py ended with status 3 after Ctrl-C at 1.0 s"),
        ("while True:\n rospy.sleep(1)", "NodeFailed: node.py ended with status 137 after Ctrl-C at 1.0 s\nrosspin: "
            "Ctrl-C at 1 s did not end the node; it was killed 17 s later, as roslaunch does. Does its loop check"),
    ],
)  # fmt: skip
def test_the_end_is_checked(write: Any, text: str, message: str) -> None:
    with (
        pytest.raises((IndexError, NodeFailed)) as caught,
        start(write(f"import rospy, sys\nrospy.init_node('n')\n{text}")) as node,
    ):
        node.advance(1)
    assert f"{caught.typename}: {caught.value}".startswith(message)
    node.close()  # once is enough


def test_a_keyboard_interrupt_in_the_node_is_none_in_the_test(write: Any) -> None:
    with (
        pytest.raises(NodeFailed, match="ended with status 130 after Ctrl-C") as caught,
        start(write("import time\ntime.sleep(9)")),
    ):
        pass
    assert type(caught.value.__cause__) is KeyboardInterrupt


def test_a_node_that_stands_still(write: Any) -> None:
    node = start(write("import rospy\nrospy.init_node('n')\nrospy.sleep(1)\nwhile True:\n    rospy.sleep(0)\n"))
    with pytest.raises(TimeStandsStill, match=r"node\.py:5"):
        node.advance(2)
    node.close()


def test_the_first_failure_of_a_test_is_the_one_that_is_told(write: Any) -> None:
    with pytest.raises(AssertionError, match="mine"), start(write("import time\ntime.sleep(9)")) as node:
        node.advance(1)
        raise AssertionError("mine")
    assert node.status == 130  # it was ended all the same
    with pytest.raises(RuntimeError, match=r"the node was closed at 1\.0 s"):
        node.advance(1)


# --- nothing of it is in the way --------------------------------------------------------------------------------------


def process() -> dict[str, object]:
    """What a node could change of the process."""
    loggers = {name: (logging.getLogger(name).level, logging.getLogger(name).handlers[:]) for name in (None, "asyncio")}
    return {
        "argv": (sys.argv, sys.argv[:]),
        "path": (sys.path, sys.path[:]),
        "meta_path": sys.meta_path[:],
        "environ": dict(os.environ),
        "folder": os.getcwd(),
        "modules": {name: module for name, module in sys.modules.items() if name in MODULES},
        "loggers": loggers,
        "known loggers": sorted(logging.root.manager.loggerDict),
        "hooks": (sys.excepthook, sys.unraisablehook, threading.excepthook, sys.gettrace()),
        "streams": (sys.stdin, sys.stdout, sys.stderr),
        "threads": threading.enumerate(),
        "functions": (time.sleep, time.time, threading.Lock, threading.local, os._exit, os.kill, signal.signal),
        "signals": {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)},
    }


MODULES = ("__main__", "rospy", "genpy", "std_msgs", "std_msgs.msg", "scenario", "neighbour")

NOSY = """
import concurrent.futures, logging, os, sys, threading, time
import neighbour, rospy
from std_msgs.msg import UInt32

def state():
    main = sys.modules["__main__"]
    return (sys.argv, sys.path[0], sys.path[-1], os.environ.get("NODE"), os.environ.get("TEST"), os.getcwd(),
        main.__file__, rospy.__name__, logging.getLogger("mine").level, logging.root.level, sys.excepthook.__name__,
        threading.excepthook.__name__, neighbour.VALUE, sorted(thread.name for thread in threading.enumerate()))

def hook(*args): pass
def thread_hook(args): pass

rospy.init_node("nosy", ["nosy"])
os.environ["NODE"] = "yes"
os.chdir(sys.argv[1])
sys.argv.append("more")
sys.path.append("end")
sys.excepthook, threading.excepthook = hook, thread_hook
logging.getLogger("mine").setLevel(5)
logging.root.setLevel(7)
neighbour.VALUE = 2
pool = concurrent.futures.ThreadPoolExecutor(2)
pool.submit(rospy.sleep, 0.1)
threading.Thread(target=rospy.spin, name="spinner").start()
first = state()
while not rospy.is_shutdown():
    now = state()
    print(now == first or (first, now))
    rospy.sleep(0.5)
"""


@pytest.fixture
def nosy(tmp_path: Path) -> Path:
    (tmp_path / "neighbour.py").write_text("VALUE = 1\n")
    (tmp_path / "nosy.py").write_text(NOSY)
    return tmp_path / "nosy.py"


def test_between_the_steps_the_process_is_the_test_s(
    nosy: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = process()
    with start(nosy, [str(tmp_path)]) as node:
        assert process() == before
        assert node.advance(2).console == "True\n" * 4
        assert process() == before
        monkeypatch.setenv("TEST", "mine")  # and the node's process is the node's
        monkeypatch.chdir("/")
        monkeypatch.setattr(sys, "argv", ["mine"])
        monkeypatch.setitem(sys.modules, "neighbour", sys)
        monkeypatch.setitem(sys.modules, "std_msgs", sys)
        monkeypatch.setattr(logging.getLogger("asyncio"), "level", 50)
        changed = process()
        assert node.advance(2).console == "True\n" * 4
        assert process() == changed
    assert process() == changed
    monkeypatch.undo()
    assert process() == before


@pytest.mark.parametrize("failure", [AssertionError, KeyboardInterrupt, SystemExit])
def test_a_test_that_fails_half_way_leaves_nothing_behind(
    nosy: Path, tmp_path: Path, failure: type[BaseException]
) -> None:
    before = process()
    with pytest.raises(failure), start(nosy, [str(tmp_path)]) as node:
        node.advance(0.1)
        raise failure
    assert process() == before
    assert node.status == 0
    with pytest.raises(ZeroDivisionError), start(failing("timer")) as node:
        node.advance(1)
    assert process() == before


def test_a_profiler_that_is_switched_on_between_two_steps_stays_on() -> None:
    profile = cProfile.Profile()
    with start(echo) as node:
        node.advance(1)
        profile.enable()
        try:
            node.advance(1)
            node.advance(1)
        finally:
            profile.disable()
    calls = {entry.code.co_name: entry.callcount for entry in profile.getstats() if not isinstance(entry.code, str)}
    assert calls["advance"] == 2


def test_several_nodes_at_a_time() -> None:
    def count(name: str, period: float) -> Callable[[], None]:
        def node() -> None:
            rospy.init_node(name)
            rate = rospy.Rate(1 / period)
            while not rospy.is_shutdown():
                rospy.loginfo(name)
                rate.sleep()

        return node

    alone = {name: simulate(count(name, period), 2) for name, period in (("a", 0.3), ("b", 0.5))}
    with start(count("a", 0.3)) as a:
        a.advance(0.5)
        with start(count("b", 0.5)) as b:
            for _ in range(4):
                b.advance(0.5)
                a.advance(0.25)
            assert simulate(count("b", 0.5), 2) == alone["b"]
        a.advance(0.5)
    assert (a.run, b.run) == (alone["a"], alone["b"])


def test_nodes_may_end_in_another_order_than_they_began() -> None:
    first, second = start(listener()), start(listener())
    first.advance(1)
    first.close()
    second.publish("a", 1)
    assert second.advance(1).console == "0.0 data: 1\n"
    second.close()


def test_a_node_cannot_start_or_step_another() -> None:
    with start(listener()) as outer:

        def inner() -> None:
            for attempt in (lambda: start(listener()), lambda: outer.advance(1)):
                try:
                    attempt()
                except RuntimeError as error:
                    print(error)

        with start(inner) as node:
            assert node.run.console == "a node cannot start a run of its own\n" * 2
        outer.advance(1)


def test_another_thread_cannot_go_on_with_it() -> None:
    said: list[str] = []

    def step() -> None:
        try:
            node.advance(1)
        except RuntimeError as error:
            said.append(str(error))

    with start(listener()) as node:
        thread = threading.Thread(target=step)
        thread.start()
        thread.join()
        assert said == ["a node can continue only in the thread that started it"]
        node.advance(1)


def test_a_thread_of_its_own_can_start_and_run_one() -> None:
    consoles: list[str] = []

    def run() -> None:
        with start(listener()) as node:
            node.publish("a", 1)
            consoles.append(node.advance(1).console)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert consoles == ["0.0 data: 1\n"]


def test_python_can_end_with_a_node_that_was_not_closed(nosy: Path, tmp_path: Path) -> None:
    code = "import sys; from rosspin import start; node = start(*sys.argv[1:2], sys.argv[2:]); node.advance(1)"
    command = [sys.executable, "-c", code, str(nosy), str(tmp_path)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")


def test_a_child_that_the_node_forks_ends_with_the_step(tmp_path: Path) -> None:
    def node_function() -> None:
        rospy.init_node("n")
        child = os.fork()
        (tmp_path / ("node" if child else "child")).write_text("was here")
        if child:
            os.waitpid(child, 0)
        rospy.sleep(5)

    with start(node_function) as node:
        (tmp_path / f"step {os.getpid()}").touch()
        node.advance(6)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["child", "node", f"step {os.getpid()}"]
