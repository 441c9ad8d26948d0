"""What timers would have called next when a run ended, by the rule of each ROS: what is pending is not lost."""

from __future__ import annotations

import re
import threading
import time
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from rosspin import plots, rclpy, rospy, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.measures import by_source, lost
from rosspin.results.ticks import Run
from rosspin.run.simulate import run_node
from rosspin.run.source import load_source
from rosspin.run.streams import capture
from rosspin.site.live import plot
from rosspin.world.graph import TickLog
from tests.helpers.tree import EXAMPLES

ROSPY, RCLPY = EXAMPLES / "timing_probes/src/timer_probe.py", EXAMPLES / "ros2/timer_probe.py"
LEFT = """\
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  auto timer = node->create_timer(std::chrono::milliseconds(450), [] {});
  rclcpp::TimerBase::SharedPtr cancelled = node->create_timer(std::chrono::seconds(1), [&] { cancelled->cancel(); });
  rclcpp::Rate rate(20);
  for (int pass = 0; pass < 3; pass++)
    rate.sleep();
  rclcpp::spin(node);
}
"""
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


@pytest.mark.parametrize(
    ("node", "args", "source", "wanted"),
    [
        (ROSPY, LONG[ROSPY], "callback", [2.0, 2.5]),  # roscpp's: 3.1 is the first place of a new grid
        (RCLPY, LONG[RCLPY], "lambda", [2.5, 3.0]),
        (RCLPY.with_name("rate_probe.py"), LONG[RCLPY], "Rate", [2.0, 2.5, 3.0]),  # its grid restarts, too
    ],
)
def test_while_a_call_goes_on_in_cpp(node: Path, args: str, source: str, wanted: list[float]) -> None:
    run = simulate(node.with_suffix(".cpp"), 3.1, args.split())
    assert gone(run, source) == wanted
    assert run.coming[-1].real > 3.1 and all(tick.real == 3.1 for tick in run.coming[:-1])


def test_in_cpp_what_is_on_time_loses_nothing(tmp_path: Path) -> None:
    """A timer that was cancelled has no next call, and a loop that was left for a spin no next pass."""
    node = tmp_path / "node.cpp"
    node.write_text(LEFT, encoding="utf-8")
    run = simulate(node, 3.1)
    assert [tick[:4] for tick in run.coming] == [("lambda", 7, 3.15, 3.15)]
    assert sum(tick.source == "Rate" for tick in run.ticks) == 3


def test_a_timer_that_starves() -> None:
    """Its first call stays overdue, the others are lost; and so its row says."""
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


# --- Rates: the pass that is on its way at the end is one of those that come ------------------------------------------


def of_ros1(passes: Iterable[float], after: Callable[[], object] = lambda: None) -> Callable[[], None]:
    """A node whose passes take so long (s), at 2 Hz."""

    def main() -> None:
        rospy.init_node("loops")
        rate = rospy.Rate(2)
        for work in passes:
            rospy.sleep(work)
            if rospy.is_shutdown():
                break
            rate.sleep()
        after()

    return main


def of_ros2(passes: Iterable[float], after: Callable[[], object] = lambda: None) -> Callable[[], None]:
    def main() -> None:
        rclpy.init()
        node = rclpy.create_node("loops")

        def loop() -> None:
            rate = node.create_rate(2)
            for work in passes:
                time.sleep(work)
                rate.sleep()
            after()

        threading.Thread(target=loop, daemon=True).start()
        rclpy.spin(node)

    return main


@pytest.mark.parametrize(
    ("loop", "seconds", "wanted"),
    [
        (of_ros1, 1.7, []),  # it would still catch up: the passes of 1.0 and 1.5 would begin now
        (of_ros1, 2.7, [1.5, 2.0, 2.5]),  # more than three periods late: 1.0's would begin now, and a new grid
        (of_ros2, 1.4, []),  # the pass of 1.0 would begin late
        (of_ros2, 2.7, [1.5, 2.0, 2.5]),  # and so it would here, but no other
    ],
)
def test_while_a_pass_goes_on(
    loop: Callable[[Iterable[float]], Callable[[], None]], seconds: float, wanted: list[float]
) -> None:
    run = simulate(loop([0.1, 9.0, 0.1]), seconds)
    assert [tick.number for tick in run.ticks if tick.real + tick.duration <= seconds] == [1]
    assert gone(run, "Rate") == wanted
    assert run.coming[0].number == run.ticks[-1].number + 1


@pytest.mark.parametrize("loop", [of_ros1, of_ros2])
def test_a_loop_that_sleeps_or_is_on_time_loses_nothing(
    loop: Callable[[Iterable[float]], Callable[[], None]],
) -> None:
    for seconds in (1.2, 1.05):  # in its third sleep, and in its third pass
        run = simulate(loop([0.1] * 9), seconds)
        assert gone(run, "Rate") == []
        assert run.coming[-1][1:4] == (4, 1.5, 1.5)


@pytest.mark.parametrize("loop", [of_ros1, of_ros2])
def test_a_loop_that_has_ended_has_no_pass_due(
    loop: Callable[[Iterable[float], Callable[[], object]], Callable[[], None]],
) -> None:
    """Although its Rate is still there, and its function still runs."""
    waits = rospy.spin if loop is of_ros1 else lambda: time.sleep(20)
    run = simulate(loop([0.1, 0.1], waits), 5.0)
    assert [tick.number for tick in run.ticks] == [1, 2]
    assert run.coming == () and gone(run, "Rate") == []


def test_a_rate_that_nobody_wakes() -> None:
    """Its second pass stays overdue, the passes after it are lost."""

    def main() -> None:
        rclpy.init()
        rate = rclpy.create_node("hangs").create_rate(2)
        while True:
            rate.sleep()

    run = simulate(main, 2.2)
    assert gone(run, "Rate") == [1.0, 1.5, 2.0]


@pytest.mark.parametrize("change", ["timer.reset()", "timer.timer_period_ns = 10**8"])
def test_a_timer_that_left_its_grid_has_no_period(change: str) -> None:
    """A page does not know its period: a watchdog that is always reset loses nothing."""
    text = f"""
import rclpy
rclpy.init()
node = rclpy.create_node("watchdog")
timer = node.create_timer(0.5, lambda: None)
def feed():
    {change}
node.create_timer(0.4, feed)
rclpy.spin(node)
"""
    with capture():
        result = run_node(load_source(text, "watchdog.py"), 3.0, (), Simulation(), TickLog())
    assert result.host.recording.periods() == {"feed": 0.4}


@pytest.mark.parametrize(("node", "source"), [(ROSPY, "callback"), (RCLPY, "callback")])
def test_the_plot_below_a_listing_has_the_crosses(node: Path, source: str) -> None:
    """With the period of each timer; where nothing was lost, crosses are not spoken of."""
    text = node.read_text(encoding="utf-8")
    made = plot(f"%%simulate 4 -- {LONG[node]}\n{text}")
    assert "Lost ticks: 4." in made or "Lost ticks: 3." in made
    assert "cross: lost" in made
    assert "ost" not in re.sub("<[^>]*style[^>]*>", "", plot(f"%%simulate 4\n{text}"))


def test_a_plot_has_the_crosses() -> None:
    run = simulate(RCLPY, 3.1, LONG[RCLPY].split())
    assert "Lost ticks: 2." in str(plots.timeline(run, 0.5).get_label())
    assert "Lost ticks: 0." in str(plots.timeline(run.ticks, 0.5).get_label())
