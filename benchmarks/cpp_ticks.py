"""C++ nodes: a simulated tick beside Python's and SimPy's event, the start of a run, and how long compiling takes."""

from __future__ import annotations

import os
import resource
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from statistics import median
from uuid import uuid4

from rosspin import simulate
from rosspin.cpp import nodejs

from .ratios import by_turns, line, ratio
from .ticks import in_simpy

ROSPY = """\
import rospy
rospy.init_node("node")
rospy.Timer(rospy.Duration(0.5), lambda event: None)
rospy.spin()
"""
RCLPY = """\
import rclpy
from rclpy.node import Node
rclpy.init()
node = Node("node")
node.create_timer(0.5, lambda: None)
rclpy.spin(node)
"""
ROSCPP = """\
#include "ros/ros.h"
void tick(const ros::TimerEvent&) {}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Timer timer = nh.createTimer(ros::Duration(0.5), tick);
  ros::spin();
}
"""
RCLCPP = """\
#include "rclcpp/rclcpp.hpp"
void tick() {}
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  auto timer = node->create_wall_timer(std::chrono::milliseconds(500), tick);
  rclcpp::spin(node);
}
"""
NODES = {
    "rospy.py": ROSPY,
    "rclpy.py": RCLPY,
    "roscpp.cpp": ROSCPP,
    "rclcpp.cpp": RCLCPP,
    "rclpy_threads.py": RCLPY.replace(
        "rclpy.spin(node)",
        "from rclpy.executors import MultiThreadedExecutor\nexecutor = MultiThreadedExecutor(2)\n"
        "executor.add_node(node)\nexecutor.spin()",
    ),
    "roscpp_threads.cpp": ROSCPP.replace(
        "ros::spin()", "ros::AsyncSpinner spinner(2);\n  spinner.start();\n  ros::waitForShutdown()"
    ),
    "rclcpp_threads.cpp": RCLCPP.replace(
        "rclcpp::spin(node)",
        "rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);\n"
        "  executor.add_node(node);\n  executor.spin()",
    ),
}
# Of each pair, the first takes at most a fifth of the time of the second. Those of roscpp call back in two threads, as
# rospy does in one a timer.
PAIRS = [
    ("roscpp", "rospy"),
    ("rclcpp", "rclpy"),
    ("roscpp_threads", "rospy"),
    ("rclcpp_threads", "rclpy_threads"),
]


def processor_time() -> float:
    """That of this process and of those that it has started, which may wait for their next node (s)."""
    both = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    waiting = [Path(f"/proc/{child.pid}/stat").read_text().split() for child in nodejs.IDLE]
    own = sum(int(time) for words in waiting for time in words[13:15]) / os.sysconf("SC_CLK_TCK")
    return own + sum(used.ru_utime + used.ru_stime for used in both)


def report(ticks: int = 200_000, rounds: int = 5) -> Iterator[str]:
    """The lines of the report; each measurement makes ``ticks`` ticks."""
    with tempfile.TemporaryDirectory() as folder:
        functions: dict[str, Callable[[], object]] = {"SimPy": partial(in_simpy, [500_000_000], ticks)}
        for name, text in NODES.items():
            path = Path(folder, name)
            path.write_text(text, encoding="utf-8")
            simulate(path, 1.0)  # compiled
            functions[path.stem] = partial(simulate, path, 0.5 * ticks)
        # Ticks are made when someone asks for them.
        for name in ("roscpp.cpp", "rospy.py"):
            functions[f"{Path(name).stem}, read"] = partial(_read, Path(folder, name), 0.5 * ticks)
        times = by_turns(rounds, processor_time, functions)
        begun: dict[str, Callable[[], object]] = {name: partial(simulate, Path(folder, name), 1.0) for name in NODES}
        starts = by_turns(rounds, time.perf_counter, begun)
        changed: dict[str, Callable[[], object]] = {
            name: partial(_compile, Path(folder, name), text) for name, text in NODES.items() if name.endswith(".cpp")
        }
        compiling = by_turns(rounds, time.perf_counter, changed)

    def each(name: str) -> str:
        return f"{median(times[name]) / ticks * 1e6:.2f} µs"

    yield "Processor time of a simulated tick of a timer in C++, that of Node.js included"
    for cpp, python in PAIRS:
        shown = f"{each(cpp)} / {each(python)}"
        yield line(f"  {cpp} / {python}", ratio(times, cpp, python), most=0.2, times=shown)
    cpp, python = "roscpp, read", "rospy, read"
    shown = f"{each(cpp)} / {each(python)}"
    yield line("  roscpp / rospy, and all ticks are read", ratio(times, cpp, python), times=shown)
    for cpp in ("roscpp", "rclcpp"):
        yield line(f"  {cpp} / SimPy", ratio(times, cpp, "SimPy"), most=1, times=f"{each(cpp)} / {each('SimPy')}")
    for name in changed:
        took = median(starts[name])
        yield f"  a run of one second of {name}, compiled before: {took:.3f} s (goal: below 0.3)"
        yield f"  the same, changed before: {median(compiling[name]):.1f} s"


def _read(path: Path, seconds: float) -> int:
    return len(simulate(path, seconds).ticks)


def _compile(path: Path, text: str) -> None:
    path.write_text(f"{text}// {uuid4()}\n", encoding="utf-8")
    simulate(path, 1.0)
