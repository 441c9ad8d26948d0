"""What ROS 2 costs in simulated time: a tick of rclpy's timer beside others, and a day of the timer node.

The others are a tick of rospy's timer, and one of the real rclpy's own Python on the same clock: see its tests.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from statistics import median

from rosspin import rclpy, rospy, simulate

from .ratios import by_turns, line, ratio
from .rclpy_oracle import on_the_oracle, real_rclpy

PERIOD = 0.5


def report(hours: float = 24, ticks: int = 20_000, rounds: int = 5) -> Iterator[str]:
    """The lines of the report; each measurement of a tick makes ``ticks`` of them."""
    functions: dict[str, Callable[[], object]] = {
        "rospy": lambda: run(rospy_node, ticks),
        "rclpy": lambda: run(rclpy_node, ticks),
    }
    if folder := real_rclpy():
        on_oracle = on_the_oracle(lambda: oracle_node(ticks), folder)
        functions["oracle"] = lambda: simulate(on_oracle, ticks * PERIOD)
    # The processor's time: on a busy machine the clock's includes that of others.
    times = by_turns(rounds, time.process_time, functions)
    each = {name: f"{median(times[name]) / ticks * 1e6:.1f} µs" for name in times}
    seconds = hours * 3600
    took = median(by_turns(1, time.process_time, {"day": lambda: run(logging_node, round(seconds / PERIOD))})["day"])
    yield "ROS 2 in simulated time, processor time"
    yield line(
        "  a tick of rclpy's timer / of rospy's",
        ratio(times, "rclpy", "rospy"),
        most=4.5,
        times=f"{each['rclpy']} / {each['rospy']}",
    )
    if folder:
        times_each = f"{each['rclpy']} / {each['oracle']}"
        yield line("  a tick of rclpy's timer / of its own Python's", ratio(times, "rclpy", "oracle"), times=times_each)
    yield line(
        f"  {hours:g} h of a timer node with its console / real time",
        seconds / took,
        least=10_000,
        times=f"{took:.2f} s",
    )


def run(node: Callable[[], None], ticks: int) -> None:
    """Run a node until it has ticked so often."""
    found = len(simulate(node, ticks * PERIOD).ticks)
    if found != ticks:
        raise AssertionError(f"{found} ticks for {ticks}")


def rospy_node() -> None:
    """A timer that does nothing."""
    rospy.init_node("node")
    rospy.Timer(rospy.Duration(PERIOD), lambda event: None)
    rospy.spin()


def rclpy_node() -> None:
    """The same in ROS 2."""
    rclpy.init()
    node = rclpy.create_node("node")
    node.create_timer(PERIOD, lambda: None)
    rclpy.spin(node)


def oracle_node(ticks: int) -> None:
    """The same, with whatever is imported as rclpy; its ticks are not recorded, so it counts them itself."""
    import rclpy  # type: ignore[import-not-found]

    calls: list[None] = []
    rclpy.init()
    node = rclpy.create_node("node")
    node.create_timer(PERIOD, lambda: calls.append(None))
    try:
        rclpy.spin(node)
    finally:
        if len(calls) != ticks:
            raise AssertionError(f"{len(calls)} ticks for {ticks}")


def logging_node() -> None:
    """A timer that counts on the console."""
    count = 0

    def callback() -> None:
        nonlocal count
        count += 1
        node.get_logger().info(f"[SPINNER PY NODE] counter = {count}")

    rclpy.init()
    node = rclpy.create_node("spinner_py_node")
    node.create_timer(PERIOD, callback)
    rclpy.spin(node)
