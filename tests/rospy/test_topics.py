"""Topics in a run: what is recorded, measured and lost; random graphs against a plain model."""

from __future__ import annotations

import random
import subprocess
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from rosspin import NotSimulated, Run, rospy, simulate
from rosspin.exercises.advice import advice
from rosspin.measures import describe_lateness, describe_periods, periods, topic_ticks
from rosspin.plots import lateness, period_histogram, timeline
from rosspin.results.ticks import Message, Tick
from rosspin.rospy.topics import LATER_PUBLISHER, LATER_SUBSCRIBER
from rosspin.world.world import current_world
from tests.helpers.graphs import LENGTH, Sink, Source
from tests.helpers.seeds import SEED

# --- what a run tells of its topics -----------------------------------------------------------------------------------


def talker(period: float = 0.5, **options: Any) -> Callable[[], None]:
    """A node that publishes a counter."""

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("talker")
        publisher = rospy.Publisher("~counter", UInt32, queue_size=1, **options)
        counter = 0
        rate = rospy.Rate(1 / period)
        while not rospy.is_shutdown():
            counter += 1
            publisher.publish(counter)
            rate.sleep()

    return node


def test_a_run_tells_what_went_over_its_topics() -> None:
    run = simulate(talker(), 2.0)
    assert [(topic, node, time) for topic, node, time, _ in run.messages] == [
        ("/talker/counter", "/talker", 0.5 * number) for number in range(5)
    ]
    assert [message.message.data for message in run.messages] == [1, 2, 3, 4, 5]


def test_a_run_without_topics_has_no_messages() -> None:
    assert simulate(lambda: rospy.init_node("n"), 1).messages == ()
    assert Run("", (), 0, "simulated", 1.0, 0.0).messages == ()


def test_what_is_recorded_is_a_copy() -> None:
    def node() -> None:
        from std_msgs.msg import Float64MultiArray

        rospy.init_node("n")
        publisher = rospy.Publisher("a", Float64MultiArray, queue_size=1)
        message = Float64MultiArray(data=[1.0])
        for connected in (False, True):
            if connected:
                rospy.Subscriber("a", Float64MultiArray)
                rospy.sleep(1)
            publisher.publish(message)
            message.data.append(2.0)

    assert [tuple(message.message.data) for message in simulate(node, 2).messages] == [(1.0,), (1.0, 2.0)]


def test_what_nobody_could_be_sent_is_recorded_as_it_is() -> None:
    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("n")
        rospy.Publisher("a", UInt32, queue_size=1).publish("no number")

    assert [message.message.data for message in simulate(node, 2).messages] == ["no number"]


def test_a_message_that_cannot_be_sent_is_an_error_and_not_recorded() -> None:
    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("n")
        publisher = rospy.Publisher("a", UInt32, queue_size=1)
        rospy.Subscriber("a", UInt32)
        rospy.sleep(1)
        for value in (-1, 2):
            try:
                publisher.publish(value)
            except rospy.ROSSerializationException as error:
                print(error)

    run = simulate(node, 2)
    assert "field data must be unsigned integer type" in run.console
    assert "rosspin: a message for /a that could not be sent has broken the connection to /n" in run.console
    assert [message.message.data for message in run.messages] == [2]


def test_a_package_that_is_not_there_is_not_simulated() -> None:
    def node() -> None:
        import_module("control_srvs.srv")

    with pytest.raises(NotSimulated, match="control_srvs"):
        simulate(node, 1)


def test_what_is_not_simulated_ends_the_run_in_a_callback() -> None:
    def node() -> None:
        from std_msgs.msg import Empty

        rospy.init_node("n")
        publisher = rospy.Publisher("a", Empty, queue_size=1)
        rospy.Subscriber("a", Empty, lambda message: rospy.MasterProxy())
        rospy.sleep(1)
        publisher.publish()
        rospy.spin()

    with pytest.raises(NotSimulated, match=r"rospy\.MasterProxy"):
        simulate(node, 2)


def test_messages_of_the_node_s_own_package(tmp_path: Path) -> None:
    package = tmp_path / "my_robot"
    for name, text in {
        "package.xml": "<package><name>my_robot</name></package>",
        "msg/Wheel.msg": "Header header\nfloat32[2] speeds\nuint8 LEFT=0\n",
        "src/node.py": "import rospy\nfrom my_robot.msg import Wheel\n"
        "rospy.init_node('n')\npublisher = rospy.Publisher('wheel', Wheel, queue_size=1)\n"
        "rospy.Subscriber('wheel', Wheel, lambda wheel: print(wheel.speeds[Wheel.LEFT], wheel.header.seq))\n"
        "rospy.sleep(1)\npublisher.publish(speeds=[0.5, 1.5])\nrospy.sleep(1)\n",
    }.items():
        path = package / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    assert simulate(package / "src/node.py", 3).console == "0.5 1\n"
    assert "my_robot" not in sys.modules


def test_a_run_that_imports_no_message_reads_no_definition() -> None:
    code = (
        "from rosspin import rospy, simulate; from rosspin.messages import library\n"
        "simulate(lambda: rospy.init_node('n'), 1); print(library._carried.cache_info().currsize)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "0\n"


def test_the_delays_of_connecting() -> None:
    """A later subscriber is connected after 5 ms, a later publisher after 100 ms."""

    def node() -> None:
        from std_msgs.msg import Empty

        rospy.init_node("n")
        one = rospy.Publisher("a", Empty, queue_size=1)
        rospy.Subscriber("a", Empty)
        rospy.Subscriber("b", Empty)
        two = rospy.Publisher("b", Empty, queue_size=1)
        for publisher in (one, two):
            while not publisher.get_num_connections():
                rospy.sleep(0.001)
            print(round(rospy.get_time(), 3))

    assert (LATER_SUBSCRIBER, LATER_PUBLISHER) == (5_000_000, 100_000_000)
    assert simulate(node, 2).console == "0.005\n0.1\n"


@pytest.mark.parametrize(
    ("callback", "text"),
    [
        (lambda: None, "A subscriber passes its callback one argument"),
        (None, ""),
        ("no function", "Pass a subscriber the callback itself"),
    ],
)
def test_advice_on_a_callback(callback: Any, text: str) -> None:
    errors: list[BaseException] = []

    def node() -> None:
        from std_msgs.msg import Empty

        rospy.init_node("n")
        publisher = rospy.Publisher("a", Empty, queue_size=1)
        rospy.Subscriber("a", Empty, callback)
        rospy.sleep(1)
        publisher.publish()
        rospy.sleep(1)
        errors.extend(current_world().errors)

    simulate(node, 5)
    assert [advice(error)[: len(text)] for error in errors] == [text] * bool(text)


# --- measures and plots -----------------------------------------------------------------------------------------------


def test_a_topic_is_measured_as_ticks_are() -> None:
    ticks = topic_ticks(simulate(talker(), 2.0).messages, "/talker/counter")
    assert periods(ticks) == [0.5] * 4
    assert describe_lateness(ticks) == "All 5 ticks were on time."
    assert describe_periods(ticks) == "Every period was 0.5 s; there was no jitter."
    for plot in (timeline(ticks), lateness(ticks), period_histogram(ticks)):
        assert "/talker/counter" in str(plot.get_label())


def test_the_grid_of_a_topic_is_its_own_or_the_one_that_is_given() -> None:
    messages = [Message("/a", "/n", time, None) for time in (1.0, 2.0, 3.25, 4.0)] + [Message("/b", "/n", 0, None)]
    assert [tick.expected for tick in topic_ticks(messages, "/a")] == [1.0, 2.0, 3.0, 4.0]
    assert [tick.lateness for tick in topic_ticks(messages, "/a", 0.5)] == [0.0, 0.5, 1.25, 1.5]
    assert topic_ticks(messages, "/b") == [Tick("/b", 1, 0, 0, 0.0)]
    assert topic_ticks(messages, "/c") == []


# --- random graphs ----------------------------------------------------------------------------------------------------

# All times are whole milliseconds, and no two things happen at the same one, so that the model need not know who goes
# first: each period has a remainder of its own.


def draw_graph(seed: int) -> tuple[list[Source], list[Sink]]:
    """At most one publisher and one subscriber of a topic, so that each has a connection of its own."""
    draw = random.Random(seed)
    sources, sinks = [], []
    for number in range(draw.randint(1, 5)):
        topic = f"/topic{number}"
        sources.append(
            Source(
                topic,
                draw.randrange(0, 1000, 100) + 10 + number,
                draw.randrange(1200, 1600, 100) + 10 * number if draw.random() < 0.6 else 0,
                draw.randrange(150, 700, 50),  # 100 would publish as they connect
                draw.random() < 0.3,
            )
        )
        if draw.random() < 0.9:
            takes = draw.choice((0, draw.randrange(3, 1500, 10)))
            sinks.append(Sink(topic, draw.randrange(0, 2000, 100) + 50 + number, takes, draw.choice((None, 1, 2, 3))))
    return sources, sinks


def in_a_node(sources: Sequence[Source], sinks: Sequence[Sink]) -> Run:
    def node() -> None:
        import threading
        import time

        from std_msgs.msg import UInt32

        def publish(source: Source) -> None:
            time.sleep(source.made / 1000)
            publisher = rospy.Publisher(source.topic, UInt32, queue_size=1, latch=source.latch)
            time.sleep(max(0, source.first - source.made) / 1000)
            number = 0
            while True:
                publisher.publish(number)
                number += 1
                time.sleep(source.period / 1000)

        def subscribe(sink: Sink) -> None:
            def callback(message: Any) -> None:
                print(round(time.time() * 1000), sink.topic, message.data)
                time.sleep(sink.takes / 1000)

            time.sleep(sink.made / 1000)
            rospy.Subscriber(sink.topic, UInt32, callback, queue_size=sink.queue_size)

        rospy.init_node("graph")
        for source in sources:
            threading.Thread(target=publish, args=[source], daemon=True).start()
        for sink in sinks:
            threading.Thread(target=subscribe, args=[sink], daemon=True).start()
        rospy.sleep(LENGTH / 1000)

    return simulate(node, 60)


def in_the_model(source: Source, sink: Sink) -> list[tuple[int, str, int]]:
    """When the callback is called with what: a queue and two delays, and no threads."""
    connected = sink.made + 5 if source.made < sink.made else source.made + 100
    start = max(source.first, source.made)
    published = [(time, number) for number, time in enumerate(range(start, LENGTH, source.period))]
    arrived = [(time, number) for time, number in published if time >= connected]
    before = [number for time, number in published if time < connected]
    if source.latch and before:
        arrived.insert(0, (connected, before[-1]))
    called, free = [], 0
    while arrived:
        now = max(free, arrived[0][0])
        batch = [number for time, number in arrived if time <= now]
        del arrived[: len(batch)]
        for number in batch[-(sink.queue_size or len(batch)) :]:
            if now <= LENGTH:
                called.append((now, sink.topic, number))
            now += sink.takes
        free = now
    return called


@pytest.mark.parametrize("seed", range(SEED, SEED + 100))
def test_a_random_graph_loses_what_a_plain_model_loses(seed: int) -> None:
    sources, sinks = draw_graph(seed)
    run = in_a_node(sources, sinks)
    again = in_a_node(sources, sinks)
    # Each run has message classes of its own, which are never equal.
    assert (again.console, repr(again.messages)) == (run.console, repr(run.messages))
    seen = sorted((int(time), topic, int(number)) for time, topic, number in map(str.split, run.console.splitlines()))
    by_topic = {source.topic: source for source in sources}
    expected = sorted(call for sink in sinks for call in in_the_model(by_topic[sink.topic], sink))
    # What happens as the main ends may or may not be seen.
    assert [call for call in seen if call[0] < LENGTH] == [call for call in expected if call[0] < LENGTH]


def within(body: Callable[[Any, Any], None]) -> str:
    """What a node prints that does something with a publisher, and with the class of its messages."""

    def node() -> None:
        from std_msgs.msg import Header

        rospy.init_node("n")
        body(rospy.Publisher("a", Header, queue_size=1, latch=True), Header)

    return simulate(node, 5).console


def test_what_a_hook_publishes_arrives_in_its_node_and_no_later() -> None:
    def body(publisher: Any, Header: Any) -> None:
        rospy.Subscriber("a", Header, lambda message: print(message.frame_id))
        rospy.on_shutdown(lambda: publisher.publish(frame_id="of the hook"))
        rospy.sleep(1)
        rospy.signal_shutdown("end")
        publisher.publish(frame_id="too late")

    assert within(body) == "of the hook\n"
