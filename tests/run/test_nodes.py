"""Several nodes in one simulated run: each a process to itself, watched over as roslaunch does."""

from __future__ import annotations

import logging
import os
import random
import signal
import sys
import time
import warnings
from collections.abc import Callable
from importlib import import_module
from typing import Any, NamedTuple

import pytest

from rosspin import Node, NotSimulated, Run, TimeStandsStill, rospy, simulate, start
from rosspin.rospy.topics import LATER_PUBLISHER, LATER_SUBSCRIBER
from tests.helpers.graphs import LENGTH, Sink, Source
from tests.helpers.seeds import SEED

NS = 1_000_000_000


def talker(period: float = 0.5, name: str = "talker", **options: Any) -> Callable[[], None]:
    """A node that publishes a counter on ``counter``, from 1 at time 0."""

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node(name)
        publisher = rospy.Publisher("counter", UInt32, queue_size=1, **options)
        rate = rospy.Rate(1 / period)
        count = 0
        while not rospy.is_shutdown():
            count += 1
            publisher.publish(count)
            rate.sleep()

    return node


def listener(callback: Callable[[int], None], delay: float = 0.0) -> Callable[[], None]:
    """A node that hands on what comes on ``counter``, to which it listens after a while."""

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("listener")
        if delay:
            rospy.sleep(delay)
        rospy.Subscriber("counter", UInt32, lambda message: callback(message.data))
        rospy.spin()

    return node


def lines(run: Run) -> list[str]:
    """A run's console without the last lines, in which its nodes are ended."""
    return [line for line in run.console.splitlines() if not line.endswith("killing on exit")]


# --- one graph, one clock, one parameter server -----------------------------------------------------------------------


def test_messages_go_from_node_to_node() -> None:
    heard: list[tuple[int, int]] = []
    run = simulate([talker(), listener(lambda data: heard.append((data, rospy.Time.now().to_nsec())))], 2)
    assert heard == [(number, (number - 1) * NS // 2) for number in (2, 3, 4, 5)]
    assert {(message.topic, message.node) for message in run.messages} == {("/counter", "/talker")}
    assert run.status == 0 and run.runtime == "simulated"


@pytest.mark.parametrize(
    ("nodes", "first"),
    [
        ([lambda heard: talker(0.001), lambda heard: listener(heard, 0.05)], 0.05 + LATER_SUBSCRIBER / NS),
        ([lambda heard: listener(heard), lambda heard: talker(0.001)], LATER_PUBLISHER / NS),
    ],
    ids=["subscriber made second", "publisher made second"],
)
def test_what_is_published_before_the_connection_stands_is_lost(nodes: Any, first: float) -> None:
    heard: list[int] = []
    simulate([make(heard.append) for make in nodes], 0.2)
    # At the very instant the loop publishes before or after the connection, by who began to wait first.
    assert heard[0] in (round(first * 1000) + 1, round(first * 1000) + 2)
    assert heard == list(range(heard[0], 202))


def test_a_latched_message_comes_with_the_connection() -> None:
    heard: list[tuple[int, float]] = []

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("talker")
        rospy.Publisher("counter", UInt32, queue_size=1, latch=True).publish(7)
        rospy.spin()

    simulate([node, listener(lambda data: heard.append((data, rospy.get_time())), 1.0)], 2)
    assert heard == [(7, 1.0 + LATER_SUBSCRIBER / NS)]


def test_two_publishing_nodes_overlap_in_the_same_callback() -> None:
    began: list[tuple[int, float]] = []

    def take_a_while(data: int) -> None:
        began.append((data, rospy.get_time()))
        rospy.sleep(0.8)

    talkers = [Node(talker(1.0), name=f"talker{number}") for number in (1, 2)]
    simulate([*talkers, listener(take_a_while)], 2)
    assert began == [(2, 1.0), (2, 1.0), (3, 2.0), (3, 2.0)]


def test_whoever_publishes_is_told_of_another_type(capsys: Any) -> None:
    def other() -> None:
        from std_msgs.msg import String

        rospy.init_node("other")
        rospy.Subscriber("counter", String, rospy.loginfo)
        rospy.spin()

    quiet = Node(other, output="log")
    (line,) = lines(simulate([talker(), quiet], 1))
    assert (
        "Could not process inbound connection: topic types do not match: [std_msgs/String] vs. [std_msgs/UInt3" in line
    )
    assert "'callerid': '/other'" in line


def test_parameters_are_those_of_the_run() -> None:
    seen: list[Any] = []

    def writes() -> None:
        rospy.init_node("writes")
        rospy.set_param("/limit", 3)
        rospy.set_param("~own", 4)

    def reads() -> None:
        rospy.init_node("reads")
        rospy.sleep(1)
        seen.append((rospy.get_param("/limit"), rospy.get_param("/writes/own"), rospy.get_param("~rate")))

    simulate([writes, Node(reads, ["_rate:=10"])], 2)
    assert seen == [(3, 4, 10)]
    assert simulate(lambda: rospy.get_param("/limit"), 1).status == 1


def test_what_a_node_has_sent_before_it_ends_still_arrives() -> None:
    heard: list[int] = []

    def node() -> None:
        from std_msgs.msg import UInt32

        rospy.init_node("talker")
        publisher = rospy.Publisher("counter", UInt32, queue_size=10)
        rospy.sleep(1)
        for number in range(5):
            publisher.publish(number)
        os._exit(0)

    def slow(data: int) -> None:
        heard.append(data)
        rospy.sleep(0.1)

    simulate([node, listener(slow)], 3)
    assert heard == [0, 1, 2, 3, 4]


def test_a_second_node_of_a_name_takes_the_place_of_the_first() -> None:
    def node() -> None:
        rospy.init_node("twin")
        rospy.on_shutdown(lambda: print("hook", rospy.get_time()))
        rospy.spin()
        print("ended", rospy.get_time())

    def later() -> None:
        time.sleep(1)
        node()

    assert lines(simulate([node, later], 3)) == [
        "shutdown request: [/twin] Reason: new node registered with same name",
        "hook 1.1",
        "ended 1.5",
        "[node-1] process has finished cleanly",
        "hook 3.0",
        "ended 3.5",
    ]


def test_anonymous_nodes_of_a_name_get_along() -> None:
    names: list[str] = []

    def node() -> None:
        rospy.init_node("worker", anonymous=True)
        names.append(rospy.get_name())
        rospy.spin()

    assert lines(simulate([node, node], 1)) == []
    assert len(set(names)) == 2


def test_the_sources_of_ticks_begin_with_the_nodes_names() -> None:
    def node() -> None:
        rospy.init_node("timers")
        rospy.Timer(rospy.Duration(1), lambda event: rospy.sleep(0.25))
        rospy.spin()

    run = simulate([Node(node, name="a"), Node(node, name="b", namespace="/ns"), talker(1.0)], 1)
    assert [
        (tick.source, tick.number, tick.real, tick.duration) for tick in run.ticks if "Rate" not in tick.source
    ] == [
        ("/a <lambda>", 1, 1.0, 0.25),
        ("/ns/b <lambda>", 1, 1.0, 0.25),
    ]
    assert {tick.source for tick in run.ticks} == {"/a <lambda>", "/ns/b <lambda>", "/talker Rate"}


# --- each a process to itself -----------------------------------------------------------------------------------------


def test_nodes_have_their_own_command_lines_modules_and_mains(write: Any, tmp_path: Any) -> None:
    text = """
        import sys, time
        import helper, random
        random.seed(1)
        for _ in range(2):
            helper.count += 1
            time.sleep(1)
            print(sys.argv[1:], helper.count, sys.modules["__main__"].text, random.random())
            assert sys.modules["helper"] is helper and sys.path[0].endswith("nodes")
        """
    (tmp_path / "nodes").mkdir()
    write("count = 0\n", "nodes/helper.py")
    paths = [
        write(text.replace("import helper", f"text = {name!r}; import helper", 1), f"nodes/{name}.py") for name in "ab"
    ]
    draws = random.Random(1)
    before = dict(sys.modules)
    first, second = draws.random(), draws.random()
    assert [line for line in lines(simulate([Node(path, [path.stem]) for path in paths], 5)) if "[" in line[:2]][
        :4
    ] == [f"['{name}'] {count} {name} {draw}" for count, draw in ((1, first), (2, second)) for name in "ab"]
    assert sys.modules["__main__"] is before["__main__"] and sys.modules["random"] is random
    assert "helper" not in sys.modules and "std_msgs" not in sys.modules


def test_nodes_have_their_own_surroundings(tmp_path: Any) -> None:
    """Working folder, environment, hooks, loggers, warnings, streams."""
    seen: dict[str, list[Any]] = {}

    def look(number: int) -> list[Any]:
        # What a child is given comes from the system, not from os.environ.
        child = os.popen("echo $ROSSPIN_NUMBER").read().strip()
        logger = logging.getLogger("number")
        return [
            os.path.basename(os.getcwd()),
            os.environ.get("ROSSPIN_NUMBER"),
            child,
            getattr(sys.excepthook, "number", None),
            logger.level,
            len(logging.root.handlers),
            [entry[2] for entry in warnings.filters[:1]],
            sys.stdin,
        ]

    def node(number: int) -> Callable[[], None]:
        def main() -> None:
            folder = tmp_path / str(number)
            folder.mkdir()
            os.chdir(folder)
            os.environ["ROSSPIN_NUMBER"] = str(number)
            sys.excepthook = lambda *error: print("hook", number)
            sys.excepthook.number = number  # type: ignore[attr-defined]
            logging.getLogger("number").setLevel(number)
            logging.root.handlers[:] = [logging.NullHandler()] * number
            warnings.simplefilter("ignore", [UserWarning, FutureWarning][number - 1])
            sys.stdin = number
            time.sleep(1)
            seen[str(number)] = look(number)
            time.sleep(1)
            raise RuntimeError

        return main

    before = [
        os.getcwd(),
        dict(os.environ),
        sys.excepthook,
        logging.root.handlers[:],
        list(warnings.filters),
        sys.stdin,
    ]
    run = simulate([node(1), node(2), lambda: seen.update(other=look(0))], 5)
    kinds = [UserWarning, FutureWarning]
    for number in (1, 2):
        expected = [str(number), str(number), str(number), number, number, number, [kinds[number - 1]], number]
        assert seen[str(number)] == expected
    assert seen["other"][:4] == [os.path.basename(before[0]), None, "", None]  # type: ignore[arg-type]
    assert [line for line in lines(run) if line.startswith("hook")] == ["hook 1", "hook 2"]
    after = [os.getcwd(), dict(os.environ), sys.excepthook, logging.root.handlers[:], list(warnings.filters), sys.stdin]
    assert after == before
    assert "ROSSPIN_NUMBER" not in os.popen("env").read()


def test_the_environment_that_a_node_is_given() -> None:
    def node() -> None:
        print(os.environ["LEVEL"], rospy.get_namespace())

    text = simulate([Node(node, env={"LEVEL": "3"}, namespace="/robot"), Node(node, env={"LEVEL": "4"})], 1).console
    assert text.splitlines()[:2] == ["3 /robot/", "4 /"]


def test_a_node_begins_in_its_folder(tmp_path: Any) -> None:
    text = simulate([Node(lambda: print(os.getcwd()), cwd=str(tmp_path)), lambda: print(os.getcwd())], 1).console
    assert text.splitlines()[:2] == [str(tmp_path), os.getcwd()]


def test_what_a_quiet_node_prints_is_not_shown_but_its_errors_are() -> None:
    def node() -> None:
        rospy.init_node("quiet")
        print("not shown")
        rospy.loginfo("not shown")
        rospy.logwarn("shown")

    assert lines(simulate([Node(node, output="log")], 1)) == [
        "[WARN] [0.000000]: shown",
        "[node-1] process has finished cleanly",
        "all processes on machine have died, roslaunch will exit",
    ]


def test_each_node_has_its_own_end() -> None:
    """Functions for the end, threads that are no daemons, threads that are, and a pool."""

    def node(number: int) -> Callable[[], None]:
        def outlive() -> None:
            rospy.sleep(number + 0.5)
            print("thread", number)

        def main() -> None:
            import atexit
            import threading
            from concurrent.futures import ThreadPoolExecutor

            rospy.init_node(f"node{number}")
            atexit.register(print, "at exit", number)
            rospy.on_shutdown(lambda: print("hook", number))
            ThreadPoolExecutor().submit(rospy.sleep, number)
            threading.Thread(target=outlive).start()
            rospy.Timer(rospy.Duration(1), lambda event: print("tick", number, round(rospy.get_time())))

        return main

    assert lines(simulate([node(1), node(2)], 9)) == [
        *("tick 1 1", "tick 2 1", "thread 1", "at exit 1", "hook 1", "[main-1] process has finished cleanly"),
        *("tick 2 2", "thread 2", "at exit 2", "hook 2", "[main-2] process has finished cleanly"),
        "all processes on machine have died, roslaunch will exit",
    ]


def test_a_node_that_exits_at_once_takes_no_other_with_it() -> None:
    heard: list[int] = []

    def node() -> None:
        import threading

        rospy.init_node("node")
        rospy.on_shutdown(lambda: print("never"))
        threading.Timer(1.0, os._exit, (3,)).start()
        try:
            rospy.sleep(5)
        finally:
            print("never")

    assert lines(simulate([node, talker(), listener(heard.append)], 2)) == [
        "[node-1] process has died [exit code 3, cmd node]."
    ]
    assert heard == [2, 3, 4, 5]


def test_the_child_of_a_node_ends_where_the_node_would() -> None:
    def node() -> None:
        child = os.fork()
        if child:
            print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        else:
            sys.exit(3)

    assert lines(simulate([node, talker()], 1)) == ["3", "[node-1] process has finished cleanly"]


def test_nothing_is_no_run() -> None:
    assert simulate([], 1).console == "No processes to monitor\n"


def test_a_stand_in_that_lacks_something_ends_the_run() -> None:
    def in_main() -> None:
        rospy.init_node("node")
        rospy.MasterProxy()

    def in_thread() -> None:
        rospy.init_node("node")
        rospy.Timer(rospy.Duration(1), lambda event: rospy.MasterProxy())
        rospy.spin()

    for node in (in_main, in_thread):
        with pytest.raises(NotSimulated, match=r"rospy\.MasterProxy is not simulated"):
            simulate([talker(), node], 3)
    assert simulate([talker()], 1).status == 0


def test_a_node_that_does_not_let_time_go_on_is_named(write: Any) -> None:
    path = write("import time\nwhile True:\n    time.sleep(0)\n")
    with pytest.raises(TimeStandsStill, match=r"node\.py:3: .*simulated time stands still at 0\.0 s"):
        simulate([talker(), path], 3)


# --- what roslaunch does with processes -------------------------------------------------------------------------------


def test_how_nodes_have_ended_is_said() -> None:
    def fails() -> None:
        raise ValueError("no")

    def exits() -> None:
        sys.exit(2)

    def signalled() -> None:
        time.sleep(0.3)
        os.kill(os.getpid(), signal.SIGTERM)

    run = simulate([fails, Node(exits, ["a", "b"], name="named", namespace="/ns"), signalled, lambda: None], 5)
    assert lines(run)[3:] == [
        "ValueError: no",
        "[fails-1] process has died [exit code 1, cmd fails].",
        "[ns/named-2] process has died [exit code 2, cmd exits a b __name:=named].",
        "[<lambda>-4] process has finished cleanly",
        "[signalled-3] process has died [exit code -15, cmd signalled].",
        "all processes on machine have died, roslaunch will exit",
    ]
    assert run.status == 0


def test_a_required_node_takes_all_with_it() -> None:
    def needed() -> None:
        time.sleep(1.04)
        sys.exit(2)

    def other() -> None:
        rospy.init_node("other")
        rospy.spin()
        print("other ended at", rospy.get_time())

    text = simulate([Node(needed, required=True), other], 5).console
    assert text == (
        f"{'=' * 80}REQUIRED process [needed-1] has died!\nprocess has died [exit code 2, cmd needed].\n"
        f"Initiating shutdown!\n{'=' * 80}\n"
        "[other-2] killing on exit\n[needed-1] killing on exit\nother ended at 1.5\n"
    )


def test_ctrl_c_while_all_are_being_ended_does_nothing() -> None:
    def slow() -> None:
        try:
            time.sleep(9)
        except KeyboardInterrupt:
            time.sleep(3)
            print("ended at", time.time())

    run = simulate([Node(lambda: time.sleep(0.55), required=True), slow], 1)
    assert run.console.endswith("ended at 3.6\n")


def test_a_node_is_started_again() -> None:
    def node() -> None:
        rospy.init_node("node")
        print("at", round(rospy.get_time(), 3), rospy.get_param("/starts", 0), rospy.names.get_name())
        rospy.set_param("/starts", rospy.get_param("/starts", 0) + 1)
        rospy.Timer(rospy.Duration(0.25), lambda event: None)
        rospy.sleep(0.5)
        sys.exit(1)

    run = simulate([Node(node, respawn=True, respawn_delay=0.25)], 2)
    assert [line for line in lines(run) if line.startswith("at")] == [
        "at 0.0 0 /node",
        "at 0.9 1 /node",
        "at 1.8 2 /node",
    ]
    assert lines(run)[1:3] == ["[node-1] process has died [exit code 1, cmd node].", "[node-1] restarting process"]
    assert [tick.real for tick in run.ticks] == [0.25, 0.5, 1.15, 1.4]


def test_a_node_that_is_started_again_without_delay_costs_time() -> None:
    starts: list[int] = []
    simulate([Node(lambda: starts.append(1), respawn=True)], 2)
    assert 10 <= len(starts) <= 21


def test_ctrl_c_comes_to_all() -> None:
    def node(name: str) -> Callable[[], None]:
        def main() -> None:
            rospy.init_node(name)
            rospy.on_shutdown(lambda: print(name, rospy.get_time()))
            rospy.spin()

        return main

    assert simulate([node("a"), node("b")], 3).console.splitlines() == [
        "[main-2] killing on exit",
        "b 3.0",
        "[main-1] killing on exit",
        "a 3.0",
    ]


def test_who_does_not_heed_ctrl_c_is_killed_after_sigterm(write: Any) -> None:
    def deaf(numbers: list[int]) -> Callable[[], None]:
        def main() -> None:
            def heard(number: int, frame: Any) -> None:
                print(number, time.time())

            for number in numbers:
                signal.signal(number, heard)
            while True:
                time.sleep(1)

        return main

    stubborn = write(
        """
        import signal, time
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        while True:
            try:
                time.sleep(1)
            except BaseException:
                pass
        """
    )
    run = simulate([deaf([signal.SIGINT]), deaf([signal.SIGINT, signal.SIGTERM]), stubborn], 1)
    assert run.console.splitlines() == [
        *("[node-3] killing on exit", "[main-2] killing on exit", "2 1.0", "[main-1] killing on exit", "2 1.0"),
        *(f"[{name}] escalating to SIGTERM" for name in ("node-3", "main-2", "main-1")),
        "15 16.0",
        "[node-3] escalating to SIGKILL",
        f"rosspin: MainThread was at {stubborn}:7: time.sleep(1)",
        "[main-2] escalating to SIGKILL",
        f"rosspin: MainThread was at {__file__}:{deaf.__code__.co_firstlineno + 8}: time.sleep(1)",
        "Shutdown errors:",
        " * process[node-3]: required SIGKILL. May still be running.",
        " * process[main-2]: required SIGKILL. May still be running.",
    ]


def test_eleven_nodes_are_ended_ten_at_a_time() -> None:
    ended: list[float] = []

    def node() -> None:
        try:
            time.sleep(9)
        except KeyboardInterrupt:
            time.sleep(1.05)
            ended.append(round(time.time(), 2))

    simulate([node] * 11, 3)
    assert ended == [4.05] * 10 + [5.15]


def test_several_nodes_have_no_command_line_in_common() -> None:
    with pytest.raises(ValueError, match=r"rosspin\.Node"):
        simulate([talker()], 1, ["a"])


def test_a_run_of_several_nodes_is_the_same_each_time() -> None:
    def run() -> Run:
        return simulate([talker(0.3), Node(talker(0.2), name="b"), listener(rospy.loginfo)], 5)

    first, second = run(), run()
    assert first.console == second.console and first.ticks == second.ticks
    assert [message[:3] for message in first.messages] == [message[:3] for message in second.messages]


# --- random graphs ----------------------------------------------------------------------------------------------------

# All times are whole milliseconds. Their remainders are such that no message is published at the instant in which its
# connection is made, and nothing happens at the one in which a node ends: the model need not know who goes first.


class Drawn(NamedTuple):
    """A node: what it publishes and hears, the period of its timer and when it is gone (ms)."""

    sources: list[Source]
    sinks: list[Sink]
    timer: int
    ends: int


def draw_nodes(seed: int) -> list[Drawn]:
    """Nodes that have a few topics in common; of each topic a node has at most one publisher and one subscriber."""
    draw = random.Random(seed)
    topics = [f"/topic{number}" for number in range(draw.randint(1, 3))]

    def source(topic: str) -> Source:
        number = draw.randrange(5)
        made = draw.randrange(0, 1000, 100) + 10 + number
        first = draw.randrange(1200, 1600, 100) + 10 * number if draw.random() < 0.6 else made
        return Source(topic, made, first, draw.randrange(150, 700, 50), draw.random() < 0.3)

    def sink(topic: str) -> Sink:
        takes = draw.choice((0, draw.randrange(3, 1500, 10)))
        return Sink(topic, draw.randrange(0, 2000, 100) + 50 + draw.randrange(5), takes, draw.choice((None, 1, 2, 3)))

    return [
        Drawn(
            [source(topic) for topic in topics if draw.random() < 0.6],
            [sink(topic) for topic in topics if draw.random() < 0.6],
            draw.randrange(100, 900, 50),
            draw.randrange(147, LENGTH, 50) if draw.random() < 0.3 else LENGTH + 47,
        )
        for _ in range(draw.randint(2, 5))
    ]


def as_a_node(index: int, drawn: Drawn) -> Node:
    def main() -> None:
        import threading

        from std_msgs.msg import UInt32

        def publish(source: Source) -> None:
            time.sleep(source.made / 1000)
            publisher = rospy.Publisher(source.topic, UInt32, queue_size=1, latch=source.latch)
            time.sleep((source.first - source.made) / 1000)
            number = 1000 * index
            while True:
                publisher.publish(number)
                number += 1
                time.sleep(source.period / 1000)

        def subscribe(sink: Sink) -> None:
            def callback(message: Any) -> None:
                print("heard", index, sink.topic, round(time.time() * 1000), message.data)
                time.sleep(sink.takes / 1000)

            time.sleep(sink.made / 1000)
            rospy.Subscriber(sink.topic, UInt32, callback, queue_size=sink.queue_size)

        rospy.init_node("drawn")
        rospy.Timer(rospy.Duration(0, drawn.timer * 1_000_000), lambda event: None)
        for source in drawn.sources:
            threading.Thread(target=publish, args=[source], daemon=True).start()
        for sink in drawn.sinks:
            threading.Thread(target=subscribe, args=[sink], daemon=True).start()
        time.sleep(drawn.ends / 1000)
        os._exit(0)

    return Node(main, name=f"node{index}")


Heard = tuple[int, str, int, int]  # by which node, on which topic, when (ms), what


def in_the_model(index: int, sink: Sink, sink_ends: int, sender: int, source: Source, ends: int) -> list[Heard]:
    """When a callback is called with what comes from one node: a queue and two delays, and no threads."""
    connected = sink.made + 5 if source.made < sink.made else source.made + 100
    if connected > ends:
        return []
    published = list(enumerate(range(source.first, min(ends, LENGTH), source.period), 1000 * sender))
    arrived = [(when, number) for number, when in published if when >= connected]
    before = [number for number, when in published if when < connected]
    if source.latch and before:
        arrived.insert(0, (connected, before[-1]))
    called, free = [], 0
    while arrived:
        now = max(free, arrived[0][0])
        batch = [number for when, number in arrived if when <= now]
        del arrived[: len(batch)]
        for number in batch[-(sink.queue_size or len(batch)) :]:
            called.append((index, sink.topic, now, number))
            now += sink.takes
        free = now
    return [call for call in called if call[2] < min(sink_ends, LENGTH)]


def test_each_of_several_nodes_has_its_own_parameters() -> None:
    def of_ros1() -> None:
        rospy.init_node("one", anonymous=True)
        print(rospy.get_param("~rate", "none"))

    def of_ros2() -> None:
        rclpy = import_module("rclpy")
        rclpy.init()
        print(rclpy.create_node("two").declare_parameter("rate", "none").value)

    for node, name in ((of_ros1, "~rate"), (of_ros2, "rate")):
        nodes: list[Any] = [Node(node, parameters={name: "5"}), Node(node, name="other", parameters={name: "x"}), node]
        assert simulate(nodes, 1.0).console.splitlines()[:3] == ["5", "x", "none"]
        with start(nodes) as started:
            assert started.run.console.split("\n")[:3] == ["5", "x", "none"]
    wrong: list[Any] = [Node(of_ros2, parameters={"rate": {}}), of_ros2]
    with pytest.raises(TypeError, match="the parameter rate can be a bool"):
        simulate(wrong, 1.0)
    with pytest.raises(TypeError, match="the parameter rate can be a bool"):
        start(wrong)


@pytest.mark.parametrize("seed", range(SEED, SEED + 100))
def test_a_random_graph_of_nodes_loses_what_a_plain_model_loses(seed: int) -> None:
    drawn = draw_nodes(seed)
    runs = [simulate([as_a_node(*each) for each in enumerate(drawn)], LENGTH / 1000 + 1) for _ in range(2)]
    (run, *_), (text, again) = runs, [run.console + repr(run.ticks) + repr(run.messages) for run in runs]
    assert again == text
    heard = [line.split()[1:] for line in run.console.splitlines() if line.startswith("heard")]
    calls = [(int(index), topic, int(when), int(number)) for index, topic, when, number in heard]
    assert sorted(call for call in calls if call[2] < min(drawn[call[0]].ends, LENGTH)) == sorted(
        call
        for index, listener in enumerate(drawn)
        for sink in listener.sinks
        for sender, talker in enumerate(drawn)
        for source in talker.sources
        if source.topic == sink.topic
        for call in in_the_model(index, sink, listener.ends, sender, source, talker.ends)
    )
    for index, each in enumerate(drawn):
        ticks = [round(tick.real * 1000) for tick in run.ticks if tick.source == f"/node{index} <lambda>"]
        assert ticks == list(range(each.timer, each.ends, each.timer))
