"""What timers would have called next when a run ended, by the rule of each ROS: what is pending is not lost."""

from __future__ import annotations

from pathlib import Path

import pytest
from tree import EXAMPLES

from rosspin import plots, rclpy, rospy, simulate
from rosspin.measures import by_source, lost
from rosspin.results.ticks import Run
from rosspin.site.pages import _by_rule

ROSPY, RCLPY = EXAMPLES / "timing_probes/src/timer_probe.py", EXAMPLES / "ros2/timer_probe.py"
LONG = {ROSPY: "_block:=9.0 _block_call:=3", RCLPY: "--ros-args -p block:=9.0 -p block_call:=3"}


def gone(run: Run, source: str) -> list[float]:
    ticks, coming = by_source(run.ticks), by_source(run.coming)
    return lost(ticks.get(source, []), 0.5, coming.get(source, []))


@pytest.mark.parametrize(
    ("node", "seconds", "wanted"),
    [
        (ROSPY, 3.0, []),  # it would still catch up
        (ROSPY, 4.0, [2.5, 3.0, 3.5, 4.0]),  # it would begin a new grid
        (RCLPY, 3.1, [2.5, 3.0]),  # one call comes late, and no other
        (RCLPY, 1.9, []),
    ],
)
def test_while_a_call_goes_on(node: Path, seconds: float, wanted: list[float]) -> None:
    run = simulate(node, seconds, LONG[node].split())
    assert gone(run, run.ticks[0].source) == wanted


def test_a_timer_that_starves() -> None:
    """Its first call is overdue for ever, the others are lost; and so its row says."""
    args = "--ros-args -p block:=0.8 -p second_timer:=true -p executor:=multi".split()
    run = simulate(RCLPY, 3.2, args)
    assert gone(run, "second_callback") == [1.0, 1.5, 2.0, 2.5, 3.0]
    assert [tick.number for tick in run.coming if tick.source == "second_callback"] == [1, 2]


def test_what_has_ended_loses_nothing() -> None:
    def cancelled() -> None:
        rclpy.init()
        node = rclpy.create_node("ends")
        timer = node.create_timer(0.5, lambda: timer.cancel())
        rclpy.spin(node)

    def once() -> None:
        rospy.init_node("ends")
        rospy.Timer(rospy.Duration(0.5), lambda event: None, oneshot=True)
        rospy.Timer(rospy.Duration(0.5), lambda event: 1 / 0)
        rospy.spin()

    def returns() -> None:
        rospy.init_node("ends")
        rospy.Timer(rospy.Duration(0.5), lambda event: None)
        rospy.sleep(0.7)

    assert [simulate(node, 3.0).coming for node in (cancelled, once, returns)] == [(), (), ()]


@pytest.mark.parametrize(
    ("file", "args", "wanted"),
    [
        ("timing_probes/src/timer_probe.cpp", "_block:=9.0 _block_call:=3", [2.0, 2.5, 3.0]),
        ("ros2/timer_probe.cpp", "-p block:=9.0 -p block_call:=3", [2.5, 3.0]),
    ],
)
def test_in_cpp_by_their_rules(file: str, args: str, wanted: list[float]) -> None:
    """roscpp gives up even the call that is overdue: it begins a new grid when the long one returns."""
    assert gone(_by_rule(file, 3.1, args.split(), 0.5), "timerCallback") == wanted


def test_a_plot_has_the_crosses() -> None:
    run = simulate(RCLPY, 3.1, LONG[RCLPY].split())
    assert "Lost ticks: 2." in str(plots.timeline(run, 0.5).get_label())
    assert "Lost ticks: 0." in str(plots.timeline(run.ticks, 0.5).get_label())
