"""What goes wrong on purpose: each fault does what it says, by its seed, and nothing that its transport cannot do."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

import rosspin
from rosspin import Run
from rosspin.faults import ClockJump, Crash, Fault, Late, Service, Slow, Topic, read

# Nodes of either ROS: /talker publishes 1, 2, ... on /scan every 0.1 s, /robot prints when it hears which.
ROS_1 = """
    import rospy
    from std_msgs.msg import UInt32

    def talk(event):
        global number
        number += 1
        publisher.publish(number)

    def on_scan(message):
        print(f"{rospy.get_time():.3f} {message.data}")

    rospy.init_node("NAME")
    number = 0
"""
TALKER_1 = """
    publisher = rospy.Publisher("scan", UInt32, queue_size=10)
    rospy.Timer(rospy.Duration(0.1), talk)
    rospy.spin()
"""
ROBOT_1 = """
    rospy.Subscriber("scan", UInt32, on_scan, queue_size=QUEUE)
    rospy.spin()
"""
ROS_2 = """
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.qos import QoSProfile, ReliabilityPolicy
    from std_msgs.msg import UInt32

    def talk():
        global number
        number += 1
        publisher.publish(UInt32(data=number))

    def on_scan(message):
        print(f"{node.get_clock().now().nanoseconds / 1e9:.3f} {message.data}")

    rclpy.init()
    node = rclpy.create_node("NAME")
    number = 0
    profile = QoSProfile(depth=QUEUE, reliability=ReliabilityPolicy.QOS)
"""
TALKER_2 = """
    publisher = node.create_publisher(UInt32, "scan", profile)
    timer = node.create_timer(0.1, talk)
"""
ROBOT_2 = """
    node.create_subscription(UInt32, "scan", on_scan, profile)
"""
SPIN_2 = """
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
"""

Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Writes a node's file of ROS 1 or 2 with a talker, a robot, or both; its path."""

    def write(ros: int, name: str, qos: str = "BEST_EFFORT", queue: int = 10) -> Path:
        parts = {
            "talker": [TALKER_1, TALKER_2],
            "robot": [ROBOT_1, ROBOT_2],
            "both": [TALKER_1 + ROBOT_1, TALKER_2 + ROBOT_2],
        }
        text = dedent(ROS_1 if ros == 1 else ROS_2) + dedent(parts[name][ros - 1]) + dedent(SPIN_2 if ros == 2 else "")
        if ros == 1 and name == "both":
            text = text.replace("rospy.spin()\n", "", 1)
        path = tmp_path / f"{name}{ros}{qos}.py"
        text = text.replace("NAME", name).replace("QOS", qos).replace("QUEUE", str(queue))
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.fixture
def pair(write: Write) -> Callable[..., Run]:
    """Runs a talker and a robot with faults."""

    def run(ros: int, *faults: Fault, seconds: float = 2.0, **options: Any) -> Run:
        return rosspin.simulate(
            [write(ros, "talker", **options), write(ros, "robot", **options)], seconds, faults=faults
        )

    return run


def heard(run: Run) -> list[tuple[float, int]]:
    """When /robot heard which number."""
    lines = [line.split() for line in run.console.splitlines() if line[:1].isdigit()]
    return [(float(when), int(number)) for when, number in lines]


def what(run: Run) -> dict[str, int]:
    """How often faults did what."""
    return {
        each: [fault.what for fault in run.faults].count(each) for each in dict.fromkeys(f.what for f in run.faults)
    }


# --- topics -----------------------------------------------------------------------------------------------------------


def test_best_effort_loses_messages(pair: Callable[..., Run]) -> None:
    run = pair(2, Topic("/scan", drop=0.3), seconds=5.0)
    numbers = [number for _, number in heard(run)]
    lost = [fault.message.message.data for fault in run.faults if fault.message]
    assert sorted(numbers + lost) == [sent.message.data for sent in run.messages][1:]  # the first came before they met
    assert numbers == sorted(numbers)
    assert 5 <= len(lost) <= 25
    assert all(fault.message in run.messages for fault in run.faults)
    assert {(fault.what, fault.which, fault.by) for fault in run.faults} == {
        ("dropped", "/scan from /talker to /robot", 0.0)
    }


def test_the_same_seed_loses_the_same_ones(pair: Callable[..., Run]) -> None:
    first, again = (pair(2, Topic("/scan", drop=0.3)).faults for _ in range(2))
    assert [fault[:4] for fault in first] == [fault[:4] for fault in again]
    other = pair(2, Topic("/scan", drop=0.3, seed=1)).faults
    assert [fault.time for fault in first] != [fault.time for fault in other]


def test_one_more_fault_changes_no_draws(pair: Callable[..., Run]) -> None:
    alone = pair(2, Topic("/scan", drop=0.3))
    others = pair(2, Topic("/scan", delay=(0.0, 0.05)), Topic("/scan", drop=0.3), Crash("/talker", at=1.9))
    both = pair(2, Topic("/scan", drop=0.3, delay=(0.0, 0.05)))
    dropped = [[fault.time for fault in run.faults if fault.what == "dropped"] for run in (alone, others, both)]
    assert dropped[0] and dropped[1:] == [[time for time in dropped[0] if time <= 1.9], dropped[0]]


@pytest.mark.parametrize(("ros", "qos"), [(1, ""), (2, "RELIABLE"), (2, "BEST_EFFORT")])
def test_messages_come_late_and_in_order(pair: Callable[..., Run], ros: int, qos: str) -> None:
    options = {"qos": qos} if qos else {}
    run = pair(ros, Topic("/scan", delay=(0.05, 0.35)), seconds=5.0, **options)
    came = heard(run)
    numbers = [number for _, number in came]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    late = [when - number / 10 for when, number in came]
    assert min(late) >= 0.05 and max(late) <= 0.351 and max(late) - min(late) > 0.2
    assert what(run).keys() == {"delayed"}
    assert [round(fault.by, 3) for fault in run.faults][: len(late)] == pytest.approx(late, abs=0.0011)


def test_a_delay_of_one_length_moves_all(pair: Callable[..., Run]) -> None:
    assert heard(pair(1, Topic("/scan", delay=0.03), seconds=0.35)) == [(0.13, 1), (0.23, 2), (0.33, 3)]


def test_a_reader_throws_away_what_was_overtaken(pair: Callable[..., Run]) -> None:
    run = pair(2, Topic("/scan", delay=(0.0, 0.3), reorder=True), seconds=5.0)
    numbers = [number for _, number in heard(run)]
    assert numbers == sorted(set(numbers))
    overtaken = [fault.message.message.data for fault in run.faults if fault.what == "overtaken" and fault.message]
    assert overtaken and not set(overtaken) & set(numbers)
    assert all(any(number > each for number in numbers) for each in overtaken)


@pytest.mark.parametrize(
    ("ros", "options", "fault", "words"),
    [
        (1, {}, Topic("/scan", drop=0.1), "over TCP, as all of ROS 1 does, which loses nothing"),
        (1, {}, Topic("/scan", delay=(0, 1), reorder=True), "Leave out reorder=; rospy loses messages only where"),
        (2, {"qos": "RELIABLE"}, Topic("/scan", drop=0.1), "is reliable: what is lost on its way is sent again"),
        (2, {"qos": "RELIABLE"}, Topic("/scan", delay=(0, 1), reorder=True), "best effort, as with qos_profile_sensor"),
    ],
)
def test_what_a_transport_cannot_do(
    pair: Callable[..., Run], write: Write, ros: int, options: dict[str, str], fault: Fault, words: str
) -> None:
    with pytest.raises(ValueError) as error:
        pair(ros, fault, **options)
    assert words in str(error.value) and f"{fault!r}: " in str(error.value)
    assert "/talker" in str(error.value) and "/robot" in str(error.value)
    with pytest.raises(ValueError, match="/tester"):
        rosspin.start(write(ros, "robot", **options), faults=[fault])


def test_one_of_two_listeners_is_meant(write: Write, tmp_path: Path) -> None:
    robot = write(2, "robot")
    reliable = tmp_path / "logger.py"
    reliable.write_text(robot.read_text().replace('"robot"', '"logger"').replace("BEST_EFFORT", "RELIABLE"))
    nodes = [write(2, "talker", qos="RELIABLE"), robot, reliable]
    with pytest.raises(ValueError, match="from /talker to /logger is reliable"):
        rosspin.simulate(nodes, 2.0, faults=[Topic("/scan", drop=0.5)])
    run = rosspin.simulate(nodes, 2.0, faults=[Topic("/scan", drop=0.5, to="/robot")])
    assert {fault.which for fault in run.faults} == {"/scan from /talker to /robot"}


def test_what_stays_in_a_process_of_ros_2_is_left_alone(write: Write) -> None:
    run = rosspin.simulate(write(2, "both"), 0.5, faults=[Topic("/scan", drop=1.0)])
    assert len(heard(run)) == 5
    assert "rosspin: Topic('/scan', drop=1.0): no message of it went from one process to another\n" in run.console
    run = rosspin.simulate(write(1, "both"), 0.5, faults=[Topic("/scan", delay=0.05)])
    assert heard(run)[0] == (0.15, 1)


@pytest.mark.parametrize("ros", [1, 2])
def test_a_test_s_messages_go_wrong_too(write: Write, ros: int) -> None:
    with rosspin.start(write(ros, "robot"), faults=[Topic("/scan", delay=0.25)]) as node:
        node.publish("/scan", 7)
        assert heard(node.advance(0.2)) == []
        run = node.advance(0.2)
        assert (heard(run), run.faults) == ([(0.25, 7)], ())
        node.publish("/scan", 8)
        run = node.advance(0.0)
        assert [(fault.time, fault.which) for fault in run.faults] == [(0.4, "/scan from /tester to /robot")]
        assert len(node.run.faults) == 2


@pytest.mark.parametrize("ros", [1, 2])
def test_what_is_under_way_when_a_talker_is_killed_arrives(pair: Callable[..., Run], ros: int) -> None:
    run = pair(ros, Topic("/scan", delay=0.25), Crash("/talker", at=0.5))
    assert heard(run)[-1] == (0.75, 5)


def test_a_publisher_waits_for_what_is_under_way(write: Write, tmp_path: Path) -> None:
    talker = tmp_path / "waits.py"
    waits = """
        import time
        from rclpy.duration import Duration
        publisher = node.create_publisher(UInt32, "scan", profile)
        for _ in range(20):
            rclpy.spin_once(node, timeout_sec=0.01)
        publisher.publish(UInt32(data=7))
        for timeout in Duration(seconds=0.1), Duration(seconds=-1):
            print("acked", publisher.wait_for_all_acked(timeout), time.monotonic())
    """
    text = dedent(ROS_2).replace("NAME", "talker").replace("QOS", "RELIABLE").replace("QUEUE", "5") + dedent(waits)
    talker.write_text(text, encoding="utf-8")
    run = rosspin.simulate([talker, write(2, "robot", qos="RELIABLE")], 1.0, faults=[Topic("/scan", delay=0.3)])
    assert [line for line in run.console.splitlines() if line.startswith("acked")] == [
        "acked False 0.3",
        "acked True 0.5",
    ]
    assert heard(run) == [(0.5, 7)]


def test_a_kept_message_comes_once(tmp_path: Path) -> None:
    """Whoever comes late is sent what is kept and what is published meanwhile: neither is lost, nor comes twice."""
    text = dedent(ROS_2).replace("depth=QUEUE", "depth=3, durability=1").replace("QOS", "RELIABLE")
    nodes = []
    for name, part in ("talker", TALKER_2), ("robot", ROBOT_2):
        nodes.append(tmp_path / f"{name}.py")
        body = dedent(part).replace("0.1", "0.003")
        nodes[-1].write_text(text.replace("NAME", name) + body + dedent(SPIN_2), encoding="utf-8")
    numbers = [number for _, number in heard(rosspin.simulate(nodes, 0.3, faults=[Topic("/scan", delay=0.01)]))]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
    assert len(numbers) > 40


# --- nodes ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ros", [1, 2])
def test_a_crash(pair: Callable[..., Run], ros: int) -> None:
    run = pair(ros, Crash("/talker", at=0.5))
    assert heard(run)[-1][1] == 5  # what was due at that time was done
    assert [fault[:4] for fault in run.faults] == [(0.5, "killed", "/talker", 0.0)]
    assert run.status == 0  # no node has failed by itself


@pytest.mark.parametrize("ros", [1, 2])
def test_a_crash_of_the_only_node(write: Write, ros: int) -> None:
    run = rosspin.simulate(write(ros, "talker"), 2.0, faults=[Crash("/talker", at=0.5)])
    assert (run.status, len(run.ticks)) == (137, 5)
    with rosspin.start(write(ros, "talker"), faults=[Crash("/talker", at=0.5)]) as node:
        node.advance(2.0)
        assert (node.status, len(node.messages("/scan"))) == (137, 5)


def test_a_test_of_several_nodes_goes_on_after_a_crash(write: Write) -> None:
    nodes = [write(1, "talker"), write(1, "robot")]
    with rosspin.start(nodes, faults=[Crash("/talker", at=0.5)]) as node:
        assert len(heard(node.advance(1.0))) == 5
        node.publish("/scan", 99)
        assert heard(node.advance(0.1)) == [(1.0, 99)]


def test_a_launcher_restarts_what_has_crashed(write: Write, tmp_path: Path) -> None:
    nodes: list[Any] = [rosspin.Node(write(1, "talker"), respawn=True), write(1, "robot")]
    run = rosspin.simulate(nodes, 1.5, faults=[Crash("/talker", at=0.55)])
    assert "process has died [exit code -9" in run.console and "restarting process" in run.console
    numbers = [number for _, number in heard(run)]
    assert numbers == [1, 2, 3, 4, 5, *range(1, 10)]
    assert what(run) == {"killed": 1}


def test_ros2_launch_restarts_it_too(write: Write, tmp_path: Path) -> None:
    path = tmp_path / "two.launch.py"
    start = f"ExecuteProcess(cmd=['python3', {str(write(2, 'both'))!r}], output='screen', respawn=True)"
    path.write_text(
        "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\n"
        f"def generate_launch_description():\n    return LaunchDescription([{start}])\n",
        encoding="utf-8",
    )
    run = rosspin.simulate(path, 0.75, faults=[Crash("/both", at=0.25)])
    assert "process has died [exit code -9" in run.console
    numbers = [line.split()[-1] for line in run.console.splitlines() if line.startswith("[python3-1] 0.")]
    assert numbers == ["1", "2", "1", "2", "3", "4", "5"]


def test_what_did_nothing_is_said_by_no_process(write: Write, tmp_path: Path) -> None:
    path = tmp_path / "one.launch.xml"
    path.write_text(
        f"""<launch><executable cmd="python3 '{write(2, "robot")}'" output="screen"/></launch>""", encoding="utf-8"
    )
    run = rosspin.simulate(path, 1.0, faults=[Late("/robot", 1.0)])
    assert run.console.endswith("\nrosspin: Late('/robot', by=1.0): /robot met no node of another process\n")


def test_an_anonymous_node_draws_the_same_in_each_run(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its name has the number of the process, which is another one each time."""
    node = write(1, "robot")
    node.write_text(node.read_text().replace('init_node("robot"', 'init_node("robot", anonymous=True'))
    times = []
    for pid in 4711, 4712:
        monkeypatch.setattr("rosspin.rospy.client.os.getpid", lambda pid=pid: pid)
        run = rosspin.simulate([write(1, "talker"), node], 1.0, faults=[Topic("/scan", delay=(0.0, 0.1))])
        times.append(heard(run))
        assert f"/robot_{pid + 2}_" in run.faults[0].which
    assert times[0] == times[1] != []


@pytest.mark.parametrize("ros", [1, 2])
def test_a_node_that_is_found_late(pair: Callable[..., Run], ros: int) -> None:
    usual, late = heard(pair(ros)), heard(pair(ros, Late("/robot", 0.5)))
    assert [number for _, number in late] == [number for _, number in usual][5:]
    run = pair(ros, Late("/robot", 0.5))
    assert [fault[1:4] for fault in run.faults] == [("late", "/robot to /talker", 0.5)]


@pytest.mark.parametrize("ros", [1, 2])
def test_a_slow_callback(pair: Callable[..., Run], ros: int) -> None:
    """A short queue loses messages meanwhile."""
    run = pair(ros, Slow("/robot", callback="on_scan", by=0.25), queue=1)
    assert [number for _, number in heard(run)][:6] == ([1, 3, 6, 8, 11, 13] if ros == 1 else [2, 4, 7, 9, 12, 14])
    times = [when for when, _ in heard(run)]
    assert all(later - earlier >= 0.249 for earlier, later in zip(times, times[1:], strict=False))
    run = pair(ros, Slow("/talker", callback="talk", by=0.25))
    assert {round(tick.duration, 9) for tick in run.ticks[:-1]} == {0.25}
    assert what(run) == {"slowed": len(run.ticks)}


def test_slow_services_and_methods(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent(
            """
            import functools
            import rclpy
            from rclpy.node import Node
            from std_srvs.srv import Trigger

            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.create_service(Trigger, "work", self.serve)
                    self.create_timer(1.0, functools.partial(self.tick, 1))
                    self.create_timer(1.0, self.ask)
                    self.client = self.create_client(Trigger, "work")

                def serve(self, request, response):
                    return response

                def tick(self, count):
                    pass

                def ask(self):
                    self.client.call_async(Trigger.Request())

            rclpy.init()
            try:
                rclpy.spin(Robot())
            except KeyboardInterrupt:
                pass
            """
        ),
        encoding="utf-8",
    )
    faults = [Slow("robot", callback="serve", by=0.5), Slow("/robot", callback="Robot.tick", by=0.1)]
    run = rosspin.simulate(path, 1.9, faults=faults)
    assert [(call.asked, call.answered) for call in run.calls] == [(1.1, 1.6)]
    assert [fault[:3] for fault in run.faults] == [(1.0, "slowed", "/robot tick"), (1.1, "slowed", "/robot serve")]


# --- the clock --------------------------------------------------------------------------------------------------------

CLOCKS = """
    import time
    import rospy
    rospy.init_node("node")
    rospy.sleep(1.5)
    rospy.loginfo("%.1f %.1f %.1f", time.time(), rospy.get_time(), time.monotonic())
"""


def test_the_system_s_clock_is_set_and_no_steady_one(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(dedent(CLOCKS), encoding="utf-8")
    run = rosspin.simulate(path, 2.0, faults=[ClockJump(at=1.0, by=-0.5)])
    assert run.console == "[INFO] [1.000000]: 1.0 1.0 1.5\n"
    assert [fault[:4] for fault in run.faults] == [(1.0, "set", "the clock", -0.5)]


def test_rospy_s_timer_goes_on_and_says_that_it_is_early(write: Write) -> None:
    run = rosspin.simulate(write(1, "talker"), 1.0, faults=[ClockJump(at=0.5, by=-0.3)])
    assert [tick.real for tick in run.ticks] == pytest.approx([number / 10 for number in range(1, 11)])
    assert [tick.lateness for tick in run.ticks] == pytest.approx([0.0] * 5 + [-0.3] * 5)


def test_rospy_takes_the_length_of_a_callback_from_the_system_s_clock(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent(
            """
            import rospy

            def tick(event):
                print(event.last_duration)
                rospy.sleep(0.25)

            rospy.init_node("node")
            rospy.Timer(rospy.Duration(0.5), tick)
            rospy.spin()
            """
        ),
        encoding="utf-8",
    )
    run = rosspin.simulate(path, 1.1, faults=[ClockJump(at=0.625, by=0.125)])
    assert run.console == "None\n0.375\n"
    assert [tick.duration for tick in run.ticks][0] == 0.25


def test_rclpy_s_timer_on_ros_time_waits_for_its_time(write: Write) -> None:
    back = rosspin.simulate(write(2, "talker"), 1.0, faults=[ClockJump(at=0.5, by=-0.3)])
    assert [tick.real for tick in back.ticks] == pytest.approx([0.1, 0.2, 0.3, 0.4, 0.5, 0.9, 1.0])
    forward = rosspin.simulate(write(2, "talker"), 1.0, faults=[ClockJump(at=0.5, by=0.25)])
    assert [tick.real for tick in forward.ticks] == pytest.approx(
        [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.75, 0.85, 0.95]
    )


def test_who_sleeps_until_a_time_wakes_when_it_comes(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent(
            """
            import time
            import rclpy
            from rclpy.clock import Clock, ClockType
            from rclpy.duration import Duration

            rclpy.init()
            for kind in ClockType.SYSTEM_TIME, ClockType.STEADY_TIME:
                Clock(clock_type=kind).sleep_for(Duration(seconds=2))
                print(kind.name, time.monotonic())
            """
        ),
        encoding="utf-8",
    )
    run = rosspin.simulate(path, 5.0, faults=[ClockJump(at=0.5, by=1.0), ClockJump(at=1.5, by=1.0)])
    assert run.console == "SYSTEM_TIME 1.0\nSTEADY_TIME 3.0\n"


# --- what did not happen ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        (Topic("/scna", delay=0.1), "no node had the topic /scna; there were /scan"),
        (Topic("/scan", delay=0.1, to="/logger"), "there was no node /logger"),
        (Crash("/camera", at=0.1), "there was no node /camera; there were /talker, /robot"),
        (Late("/camera", 0.1), "there was no node /camera"),
        (Slow("/robot", callback="on_scna", by=0.1), "/robot called no on_scna; it called on_scan"),
        (Crash("/talker", at=9.0), "the run ends before, at 2 s"),
        (ClockJump(at=9.0, by=1.0), "the run ends before, at 2 s"),
        (ClockJump(at=0.5, by=-1.0), "the clock would tell a time before 0; begin later, with start=1.7e9"),
    ],
)
@pytest.mark.parametrize("ros", [1, 2])
def test_a_name_that_nothing_has_is_an_error(pair: Callable[..., Run], fault: Fault, words: str, ros: int) -> None:
    with pytest.raises(ValueError) as error:
        pair(ros, fault)
    assert str(error.value).startswith(f"{fault!r}: {words}")


def test_what_did_nothing_is_said(pair: Callable[..., Run], write: Write) -> None:
    run = pair(2, Topic("/scan", drop=1e-9), Crash("/talker", at=0.5), Crash("/talker", at=1.5))
    assert run.console.splitlines()[-2:] == [
        "rosspin: Topic('/scan', drop=1e-09): it befell none of 4 messages",
        "rosspin: Crash('/talker', at=1.5): the node, or the run, had ended before",
    ]
    with rosspin.start(write(2, "robot"), faults=[Late("/robot", 0.5), Crash("/robot", at=5.0)]) as node:
        node.advance(1.0)
    assert node.run.console.splitlines() == [
        "rosspin: Late('/robot', by=0.5): /robot met no node of another process",
        "rosspin: Crash('/robot', at=5.0): the node, or the run, had ended before",
    ]


def test_a_test_with_a_wrong_name_fails(write: Write) -> None:
    with pytest.raises(ValueError, match="no node had the topic /scna"):
        with rosspin.start(write(2, "robot"), faults=[Topic("/scna", drop=0.1)]):
            pass


def test_a_node_s_own_failure_comes_first(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text("import rospy\nrospy.init_node('node')\n1 / 0\n", encoding="utf-8")
    run = rosspin.simulate(path, 1.0, faults=[Topic("/scan", delay=0.1)])
    assert run.status == 1 and "ZeroDivisionError" in run.console
    assert run.console.endswith("rosspin: Topic('/scan', delay=0.1): no node had the topic /scan; there were none\n")


# --- how they are written ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Topic('/scan')", "this does nothing: say drop=0.1, or delay=0.05"),
        ("Topic('/scan', drop=2)", "drop is how likely a message is lost, from 0 to 1"),
        ("Topic('/scan', delay=-1)", "delay is a number of at least 0, in s, or the least and the most: (0.0, 0.05)"),
        ("Topic('/scan', delay=(2, 1))", "delay is a number of at least 0"),
        ("Topic('/scan', delay='x')", "delay is a number of at least 0"),
        ("Topic('/scan', delay=1, reorder=True)", "messages overtake each other only if some take longer"),
        ("Topic('/scan', duplicate=0.1)", "no transport of ROS hands a message over twice"),
        ("Topic('', drop=0.1)", "topic must be a name, such as '/scan'"),
        ("Topic(1, drop=0.1)", "topic must be a name, such as '/scan'"),
        ("Crash('/node', at=-1)", "at must be a number of at least 0, in s"),
        ("Crash('/node', at=None)", "at must be a number of at least 0, in s"),
        ("Late('/node', 0)", "by must be a number above 0, in s"),
        ("Slow('/node', callback='', by=1)", "callback is the name of a function, such as 'on_scan'"),
        ("Slow('/node', callback='f', by=-1)", "by must be a number above 0, in s"),
        ("ClockJump(at=1, by=0)", "by is how far the clock is set, in s: 1.0, or -1.0 for back"),
        ("Crash('/node')", "missing 1 required positional argument: 'at'"),
        ("Crash('/node', when=1)", "got an unexpected keyword argument 'when'"),
        ("Crush('/node', at=1)", "there is no fault Crush; there are Topic, Crash, Late, ClockJump, Slow"),
        ("Crash(open('/etc/passwd'), at=1)", 'a fault is written as in Python, as in Topic("/scan", drop=0.1)'),
        ("__import__('os').system('ls')", "a fault is written as in Python"),
        ("Crash", "a fault is written as in Python"),
        ("Crash('/node', at=1", "a fault is written as in Python"),
        ("Crash('/node', at=1, at=2)", "an argument is given twice"),
        ("Crash('/node', **{'at': 1})", "unexpected keyword argument '**'"),
        ("", "a fault is written as in Python"),
    ],
)
def test_a_wrong_fault_has_a_clear_line(text: str, words: str) -> None:
    with pytest.raises(ValueError) as error:
        read(text)
    assert words in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize(
    "fault",
    [
        Topic("/scan", drop=0.1, delay=(0.0, 0.05), reorder=True, to="/robot", seed=3),
        Topic("/scan", delay=0.05),
        Crash("/node", at=2.0),
        Late("/node", 0.4),
        ClockJump(at=3.0, by=-1.0),
        Slow("/node", callback="on_scan", by=0.2),
    ],
)
def test_a_fault_is_shown_as_it_is_written(fault: Fault) -> None:
    assert read(repr(fault)) == fault
    assert hash(fault) == hash(read(repr(fault)))


@pytest.mark.parametrize("faults", ["Crash", Crash("/node", at=1.0), [1], 7, {"drop": 0.1}])
def test_what_is_no_list_of_faults(faults: Any, write: Write) -> None:
    for call in (rosspin.start, lambda node, faults: rosspin.simulate(node, 1.0, faults=faults)):
        with pytest.raises(TypeError, match="faults is a list of Topic, Crash, Late, ClockJump, Slow, Jitter"):
            call(write(1, "talker"), faults=faults)


def test_a_name_needs_no_slash() -> None:
    assert Crash("node", at=1.0) == Crash("/node", at=1.0)


def test_a_run_without_faults_has_none(pair: Callable[..., Run]) -> None:
    assert pair(2).faults == pair(1).faults == ()


@pytest.mark.parametrize(
    "text",
    ["Crash('/a', at=1e308)", "ClockJump(at=1.0, by=1e12)", "Topic('/a', delay=1e300)", f"Topic({'-' * 20_000}1)"],
)
def test_numbers_beyond_all_bounds_are_refused(text: str) -> None:
    with pytest.raises(ValueError):
        read(text)


# --- services ---------------------------------------------------------------------------------------------------------

SERVER_1 = """
    import rospy
    from std_srvs.srv import Trigger, TriggerResponse

    def serve(request):
        print(f"asked at {rospy.get_time():.2f}")
        return TriggerResponse(success=True)

    rospy.init_node("server")
    rospy.Service("ask", Trigger, serve)
    rospy.spin()
"""
CLIENT_1 = """
    import rospy
    from std_srvs.srv import Trigger

    rospy.init_node("client")
    rospy.wait_for_service("ask")
    ask = rospy.ServiceProxy("ask", Trigger)
    for _ in range(3):
        rospy.sleep(1 - rospy.get_time() % 1)
        ask()
        print(f"answered at {rospy.get_time():.2f}")
"""
SERVER_2 = """
    import rclpy
    from rclpy.qos import QoSProfile, ReliabilityPolicy
    from std_srvs.srv import Trigger

    def serve(request, response):
        print(f"asked at {node.get_clock().now().nanoseconds / 1e9:.2f}")
        return response

    rclpy.init()
    node = rclpy.create_node("server")
    profile = QoSProfile(depth=10, reliability=ReliabilityPolicy.QOS)
    node.create_service(Trigger, "ask", serve, qos_profile=profile)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
"""
CLIENT_2 = """
    import rclpy
    from rclpy.qos import QoSProfile, ReliabilityPolicy
    from std_srvs.srv import Trigger

    def ask():
        client.call_async(Trigger.Request()).add_done_callback(answered)

    def answered(future):
        print(f"answered at {node.get_clock().now().nanoseconds / 1e9:.2f}")

    rclpy.init()
    node = rclpy.create_node("client")
    profile = QoSProfile(depth=10, reliability=ReliabilityPolicy.QOS)
    client = node.create_client(Trigger, "ask", qos_profile=profile)
    node.create_timer(1.0, ask)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
"""


@pytest.fixture
def asking(tmp_path: Path) -> Callable[..., Run]:
    """Runs a client that asks a server each second, with faults."""

    def run(ros: int, *faults: Fault, qos: str = "RELIABLE") -> Run:
        paths = []
        for name, texts in {"server": (SERVER_1, SERVER_2), "client": (CLIENT_1, CLIENT_2)}.items():
            paths.append(tmp_path / f"{name}{ros}.py")
            paths[-1].write_text(dedent(texts[ros - 1]).replace("QOS", qos))
        return rosspin.simulate(paths, 3.9, faults=faults)

    return run


def said(run: Run) -> list[str]:
    """What the nodes print, without their names."""
    return [line.rpartition("] ")[2] for line in run.console.splitlines() if " at " in line]


@pytest.mark.parametrize("ros", [1, 2])
def test_requests_and_responses_come_late(ros: int, asking: Callable[..., Run]) -> None:
    usual = said(asking(ros))
    assert usual[:4] == ["asked at 1.00", "answered at 1.00", "asked at 2.00", "answered at 2.00"]
    late = said(asking(ros, Service("/ask", request_delay=0.2, response_delay=0.3)))
    assert late == [f"{what} at {n}.{part}" for n in (1, 2, 3) for what, part in (("asked", "20"), ("answered", "50"))]
    run = asking(ros, Service("ask", response_delay=(0.1, 0.4), client="/client", seed=3))
    assert run.console == asking(ros, Service("ask", response_delay=(0.1, 0.4), client="/client", seed=3)).console
    assert said(run)[0] == "asked at 1.00" and said(run)[1] > "answered at 1.09"
    assert [(each.what, each.which) for each in run.faults] == [
        ("delayed", "the response of /ask from /server to /client")
    ] * 3


def test_what_is_best_effort_loses_requests_and_responses(asking: Callable[..., Run]) -> None:
    run = asking(2, Service("/ask", response_drop=1.0), qos="BEST_EFFORT")
    assert said(run) == ["asked at 1.00", "asked at 2.00", "asked at 3.00"]
    assert {each.which for each in run.faults} == {"the response of /ask from /server to /client"}
    assert said(asking(2, Service("/ask", request_drop=1.0), qos="BEST_EFFORT")) == []
    halves = [asking(2, Service("/ask", request_drop=0.5, seed=seed), qos="BEST_EFFORT") for seed in range(6)]
    assert all(len(said(run)) == 6 - 2 * len(run.faults) for run in halves)
    assert len({len(run.faults) for run in halves}) > 1


@pytest.mark.parametrize(("ros", "why"), [(1, "over TCP, as all of ROS 1 does"), (2, "is reliable")])
@pytest.mark.parametrize("part", ["request", "response"])
def test_what_is_reliable_loses_neither(ros: int, why: str, part: str, asking: Callable[..., Run]) -> None:
    with pytest.raises(ValueError, match=rf"^Service\('/ask', {part}_drop=0.5\): .*{why}.*Use {part}_delay="):
        asking(ros, Service("/ask", **{f"{part}_drop": 0.5}))  # type: ignore[arg-type]


def test_the_calls_of_another_client_are_left_alone(asking: Callable[..., Run]) -> None:
    run = asking(2, Service("/ask", request_delay=0.5, client="/other"))
    assert said(run)[0] == "asked at 1.00"
    assert (
        "Service('/ask', request_delay=0.5, client='/other'): no node of another process has called /ask" in run.console
    )


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("Service('/ask')", "this does nothing: say request_delay=0.5, or response_delay=0.5"),
        ("Service('', request_delay=1)", "service must be a name, such as '/reset'"),
        ("Service('/ask', request_drop=2)", "request_drop is how likely a message is lost, from 0 to 1"),
        ("Service('/ask', response_delay=(2, 1))", "response_delay is a number of at least 0, in s, or the least and"),
    ],
)
def test_a_wrong_fault_of_a_service_says_why(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=re.escape(why)):
        read(text)


@pytest.mark.parametrize("ros", [1, 2])
def test_what_a_test_asks_comes_late(ros: int, tmp_path: Path) -> None:
    path = tmp_path / "server.py"
    path.write_text(dedent((SERVER_1, SERVER_2)[ros - 1]).replace("QOS", "RELIABLE"))
    with rosspin.start(path, faults=[Service("/ask", request_delay=0.25)]) as node:
        node.advance(1)
        node.call("/ask")
        assert "asked" not in node.advance(0.2).console
        assert "asked at 1.25" in node.advance(0.2).console
