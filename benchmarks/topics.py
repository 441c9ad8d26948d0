"""Topics in simulated time: a message from publish to callback beside a timer's tick, and many topics in real time."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from functools import partial
from statistics import median
from typing import Any

from rosspin import rospy, simulate

from .ratios import by_turns, line, ratio

PERIOD = 0.001


def report(
    messages: int = 20_000, topics: int = 100, seconds: float = 10.0, nodes: int = 10, rounds: int = 5
) -> Iterator[str]:
    """The lines of the report: so many messages of one topic, so many topics at 10 Hz for so many simulated seconds.

    The topics are first those of one node, then those of so many nodes, from each to the next.
    """
    yield "Processor time of simulated topics"
    times = by_turns(
        rounds,
        time.process_time,
        {"tick": lambda: tick(messages), "message": lambda: publish(messages), "sleep": lambda: sleep(messages)},
    )
    # The loop that publishes sleeps, too; that is not the message's.
    times["message"] = [whole - slept for whole, slept in zip(times["message"], times["sleep"], strict=True)]
    each = {name: f"{median(taken) / messages * 1e6:.1f} µs" for name, taken in times.items()}
    yield line(
        "  a message from publish to callback / a timer's tick",
        ratio(times, "message", "tick"),
        most=6,
        times=f"{each['message']} / {each['tick']}",
    )
    taken = median(by_turns(rounds, time.process_time, {"many": lambda: many(topics, seconds)})["many"])
    yield line(f"  {topics} topics at 10 Hz, simulated / real time", seconds / taken, least=20, times=f"{taken:.2f} s")
    taken = median(by_turns(rounds, time.process_time, {"among": lambda: among(nodes, topics, seconds)})["among"])
    what = f"  {topics} topics at 10 Hz among {nodes} nodes, simulated / real time"
    yield line(what, seconds / taken, least=30, times=f"{taken:.2f} s")


def tick(number: int) -> None:
    """Let a timer tick so many times."""

    def node() -> None:
        rospy.init_node("timer")
        rospy.Timer(rospy.Duration(PERIOD), lambda event: None)
        rospy.sleep(number * PERIOD)

    count = len(simulate(node, number).ticks)
    if count < number - 1:
        raise AssertionError(f"{count} ticks for {number}")


def sleep(number: int) -> None:
    """Sleep so many times."""

    def node() -> None:
        rospy.init_node("sleeper")
        for _ in range(number):
            rospy.sleep(PERIOD)

    simulate(node, number)


def publish(number: int) -> None:
    """Publish so many messages to a callback, and sleep after each."""
    received: list[Any] = []

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("talker")
        publisher = rospy.Publisher("counter", UInt32, queue_size=1)
        rospy.Subscriber("counter", UInt32, received.append)
        rospy.sleep(1)
        for counter in range(number):
            publisher.publish(counter)
            rospy.sleep(PERIOD)

    simulate(node, number + 2)
    if len(received) != number:
        raise AssertionError(f"{len(received)} messages for {number}")


def many(topics: int, seconds: float) -> None:
    """Run a node with so many topics, each with a timer that publishes at 10 Hz and a callback."""
    received: list[Any] = []

    def beat(publisher: rospy.Publisher, event: object) -> None:
        publisher.publish(1)

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("many")
        for number in range(topics):
            publisher = rospy.Publisher(f"topic{number}", UInt32, queue_size=1)
            rospy.Subscriber(f"topic{number}", UInt32, received.append)
            rospy.Timer(rospy.Duration(0.1), partial(beat, publisher))
        rospy.spin()

    simulate(node, seconds)
    expected = topics * round(seconds * 10)
    if len(received) < expected - topics:
        raise AssertionError(f"{len(received)} messages for {expected}")


def among(nodes: int, topics: int, seconds: float) -> None:
    """Run so many nodes with so many topics in all, each from one node to the next."""
    received: list[Any] = []

    def beat(publisher: rospy.Publisher, event: object) -> None:
        publisher.publish(1)

    def make(index: int) -> Callable[[], None]:
        def node() -> None:
            from std_msgs.msg import UInt32

            rospy.init_node(f"node{index}")
            for number in range(topics):
                if number % nodes == index:
                    publisher = rospy.Publisher(f"topic{number}", UInt32, queue_size=1)
                    rospy.Timer(rospy.Duration(0.1), partial(beat, publisher))
                if (number + 1) % nodes == index:
                    rospy.Subscriber(f"topic{number}", UInt32, received.append)
            rospy.spin()

        return node

    simulate([make(index) for index in range(nodes)], seconds)
    expected = topics * round(seconds * 10)
    if len(received) < expected - topics:
        raise AssertionError(f"{len(received)} messages for {expected}")
