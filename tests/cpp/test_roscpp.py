"""C++ nodes of ROS 1 do in simulated time what they did on the real one."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest
from cpp_scenarios import FOLDER, SECONDS, compared, recorded, words
from tree import ROOT

from rosspin import NotSimulated, TimeStandsStill, simulate
from rosspin.results.roscpp import timer_probe

Write = Callable[[str, str], Path]

SCENARIOS = recorded("ros1.txt")
PACKAGE = ROOT / "examples" / "my_robotics_pkg" / "src"
PROBE = ROOT / "examples" / "timing_probes" / "src" / "timer_probe.cpp"


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_scenario_gives_what_it_gave_on_the_real_one(name: str) -> None:
    run = simulate(FOLDER / "ros1.cpp", SECONDS, words(name), start=1_000.0)
    assert compared(run.console, run.status) == SCENARIOS[name]


@pytest.mark.parametrize(
    "args",
    [
        "_period:=0.5",
        "_block:=1.2 _block_call:=3",
        "_block:=2.2 _block_call:=3 _second_timer:=true",
        "_block:=0.8",
        "_blocks:=0.3,1.4,0.1,0.9,0.2,2.3",
        "_period:=0.02 _block:=0.05 _block_call:=7",
    ],
)
def test_a_timer_keeps_roscpps_rule(args: str) -> None:
    run = simulate(PROBE, 5.0, args.split())
    rule = timer_probe(5.0, args.split())
    assert [(each.source, each.number) for each in run.ticks] == [
        (f"callback{' 2' if each.source == 'secondCallback' else ''}", each.number) for each in rule
    ]
    for ours, theirs in zip(run.ticks, rule, strict=True):
        # The rule leaves out how long a call takes that goes on after the end.
        duration = ours.duration if math.isnan(theirs.duration) else theirs.duration
        assert ours[2:] == pytest.approx((theirs.expected, theirs.real, duration), abs=1e-9)


STAMPED = "\x1b[0m[ INFO] [{}]: [SPINNER CPP NODE] {}\x1b[0m\n"


@pytest.mark.parametrize("name", ["spinner_cpp_node", "spinner_rate_cpp_node"])
def test_the_listings_of_the_tutorial(name: str) -> None:
    run = simulate(PACKAGE / f"{name}.cpp", 1.0, ["__ns:=/mrp"])
    first = 0 if "rate" in name else 1
    lines = [("0.000000000", "namespace of nh = /mrp/spinner_cpp_node")]
    lines += [(f"{half / 2:.9f}", f"counter = {half + 1 - first}") for half in range(first, 3)]
    assert run.console == "".join(STAMPED.format(*line) for line in lines)
    assert run.status == 0
    expected = [half / 2 for half in range(first, 3)]
    assert [(each.expected, each.real) for each in run.ticks] == [(time, time) for time in expected]
    assert {each.source for each in run.ticks} == {"Rate" if first == 0 else "timerCallback"}


def test_python_hears_cpp_and_cpp_hears_python() -> None:
    run = simulate([str(PACKAGE / "publisher_cpp_node.cpp"), str(PACKAGE / "subscriber_py_node.py")], 2.0)
    assert "[SUBSCRIBER PY NODE] counter = 3" in run.console
    assert [(each.topic, each.node, each.message.data) for each in run.messages][:2] == [
        ("/counter", "/publisher_cpp_node", 1),
        ("/counter", "/publisher_cpp_node", 2),
    ]
    run = simulate([str(PACKAGE / "publisher_py_node.py"), str(PACKAGE / "subscriber_cpp_node.cpp")], 2.0)
    assert "[SUBSCRIBER CPP NODE] counter = 3" in run.console


@pytest.mark.parametrize(
    ("body", "status", "said"),
    [
        ("int* none = nullptr; *none = argc;", 139, "it has used a null pointer"),
        ("throw 5;", 134, "terminate called after throwing an instance of 'int'"),
        ("std::vector<int> few(1); few.at(argc);", 134, "instance of 'std::out_of_range'"),
        ("return 7;", 7, ""),
        ("std::exit(3);", 3, ""),
    ],
)
def test_how_a_node_may_end(write: Write, body: str, status: int, said: str) -> None:
    node = write(f'#include "ros/ros.h"\nint main(int argc, char** argv)\n{{\n  {body}\n}}\n', "node.cpp")
    run = simulate(node, 1.0)
    assert run.status == status
    assert said in run.console


NAMED = """\
#include "ros/ros.h"
#include "std_msgs/UInt32.h"
struct Listener
{
  void hear(const std_msgs::UInt32::ConstPtr& message) { std::printf("member %u\\n", message->data); }
  void see(const std_msgs::UInt32ConstPtr& message) const { std::printf("constant %u\\n", message->data); }
};
void hear(const std_msgs::UInt32::ConstPtr& message) { std::printf("free %u\\n", message->data); }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Listener listener;
  ros::Subscriber one = nh.subscribe<std_msgs::UInt32>("topic", 1, &Listener::hear, &listener);
  ros::Subscriber two = nh.subscribe<std_msgs::UInt32>("topic", 1, &Listener::see, &listener);
  ros::Subscriber three = nh.subscribe<std_msgs::UInt32>("topic", 1, hear);
  ros::Subscriber four = nh.subscribe("topic", 1, &Listener::hear, &listener);
  ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 1);
  std_msgs::UInt32 message;
  message.data = 5;
  publisher.publish(message);
  ros::spin();
}
"""


def test_a_subscriber_may_name_its_message(write: Write) -> None:
    """As roscpp's overloads of NodeHandle::subscribe do (source: node_handle.h)."""
    console = simulate(write(NAMED, "node.cpp"), 1.0).console
    assert console.splitlines() == ["member 5", "constant 5", "free 5", "member 5"]


def test_a_loop_without_an_end_ends_the_run(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.cpp.program._MOST", 0.5)
    node = write('#include "ros/ros.h"\nint main()\n{\n  for (volatile int i = 0;; i++) {}\n}\n', "node.cpp")
    with pytest.raises(TimeStandsStill, match=r"node\.cpp: simulated time stands still at 0\.0 s, because the node"):
        simulate(node, 1.0)


@pytest.mark.parametrize(
    ("include", "body", "name"),
    [
        ('"tf/transform_listener.h"', "", "tf/transform_listener.h"),
        ("<thread>", "std::thread([] {}).join();", "std::thread"),
        (
            '"ros/ros.h"',
            'ros::init(argc, argv, "node"); ros::NodeHandle().advertiseService("name", main);',
            "ros::NodeHandle::advertiseService",
        ),
        ('"ros/ros.h"', "ros::AsyncSpinner spinner(2);", "ros::AsyncSpinner"),
    ],
)
def test_what_has_no_stand_in_is_named(write: Write, include: str, body: str, name: str) -> None:
    text = f'#include "ros/ros.h"\n#include {include}\nint main(int argc, char** argv)\n{{\n  {body}\n}}\n'
    with pytest.raises(NotSimulated) as raised:
        simulate(write(text, "node.cpp"), 1.0)
    assert str(raised.value) == f"{name} is not simulated; run this node on a real ROS"


def test_what_does_not_compile_is_said_in_the_compilers_words(write: Write) -> None:
    node: Path = write('#include "ros/ros.h"\nint main()\n{\n  ros::spinn();\n}\n', "node.cpp")
    with pytest.raises(ValueError, match=r"node\.cpp:4:8: error: no member named 'spinn' in namespace 'ros'"):
        simulate(node, 1.0)
