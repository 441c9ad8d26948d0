"""What stands in for each fault does what the real ROS does where it can be made to: patterns, not times.

It can: a queue that is full, a process that is killed, stopped or started late, a clock that is set (by what stands
before the C library's, as no test may set the machine's). It cannot without a network of one's own: a datagram that is
lost, comes twice or too late; that the reader throws away the latter two is read from Fast DDS.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from textwrap import dedent

import pytest

import rosspin
from rosspin.faults import ClockJump, Crash, Fault, Late, Slow, Topic
from rosspin.real import ros1, ros2
from rosspin.real.children import Children
from tests.helpers.launches import launch
from tests.helpers.verdicts import control

pytestmark = pytest.mark.shares(10)

NEVER = 60.0  # s

COMMON = """
    import os, sys, time
    import rclpy
    from rclpy.executors import ExternalShutdownException
    from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
    from std_msgs.msg import UInt32

    def say(*words):
        sys.stdout.write(" ".join(map(str, words)) + chr(10))
        sys.stdout.flush()

    def spin_for(seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            rclpy.spin_once(node, timeout_sec=left)

    def spin_until(condition):
        while not condition():
            rclpy.spin_once(node, timeout_sec=0.01)

    rclpy.init()
    reliable = ReliabilityPolicy.RELIABLE
    best_effort = ReliabilityPolicy.BEST_EFFORT
"""


@pytest.fixture
def ros(require: Callable[[str], None], leaves_nothing: Path) -> None:
    require("ros2")


@pytest.fixture
def write(tmp_path: Path) -> Callable[[str, str], Path]:
    """Writes a node of ROS 2; its path."""

    def write(name: str, text: str) -> Path:
        path = tmp_path / f"{name}.py"
        body = dedent(COMMON) + f'node = rclpy.create_node("{name}")\n' + dedent(text) + "rclpy.try_shutdown()\n"
        path.write_text(body, encoding="utf-8")
        return path

    return write


def simulated(nodes: Sequence[Path], *faults: Fault) -> list[str]:
    """The lines of nodes in simulated time."""
    run = rosspin.simulate(list(nodes), NEVER, faults=faults)
    assert run.faults
    return [line for line in run.console.splitlines() if line.startswith(": ")]


class Started:
    """Processes on the real ROS 2 that see each other, and their lines."""

    def __init__(self, children: Children, command: Sequence[str]) -> None:
        self._children, self._command = children, command
        self._files: list[Path] = []

    def start(self, node: Path, **environment: str) -> subprocess.Popen[bytes]:
        file = self._children.folder / f"{len(self._files)}.txt"
        self._files.append(file)
        with file.open("wb") as out:
            return self._children.start([*self._command, str(node)], out.fileno(), subprocess.STDOUT, environment)

    def lines(self) -> list[str]:
        return [line for file in self._files for line in file.read_text().splitlines() if line.startswith(": ")]

    def wait_for(self, count: int) -> None:
        """Wait until there are so many lines."""
        end = time.monotonic() + NEVER
        while len(self.lines()) < count:
            assert time.monotonic() < end, self.lines()
            time.sleep(0.02)


@pytest.fixture
def real(ros: None) -> Iterator[Started]:
    with ros2.Nodes(meet=True) as nodes:
        yield Started(nodes, [ros2.python()])


# --- what is lost -----------------------------------------------------------------------------------------------------

BURST = """
    publisher = node.create_publisher(UInt32, "scan", QoSProfile(depth=50, reliability=QOS))
    spin_until(lambda: publisher.get_subscription_count() == 1)
    spin_for(1.0)
    publisher.publish(UInt32(data=1))
    spin_for(0.5)
    for number in range(2, 21):
        publisher.publish(UInt32(data=number))
    spin_for(5.0)
"""
SLOW = """
    heard = []

    def on_scan(message):
        time.sleep(float(os.environ.get("SLOW", 0)))
        heard.append(message.data)

    node.create_subscription(UInt32, "scan", on_scan, QoSProfile(depth=DEPTH, reliability=QOS))
    spin_until(lambda: heard)
    spin_for(1.0)
    spin_until(lambda: heard[-1] == 20)
    say(":", *heard)
"""


@pytest.mark.parametrize("qos", ["best_effort", "reliable"])
def test_a_full_queue_loses_the_oldest(real: Started, write: Callable[[str, str], Path], qos: str) -> None:
    """By a callback that is slow: a fault here, a sleep there. The queue is the subscription's, reliable or not."""
    nodes = [write("talker", BURST.replace("QOS", qos))]
    nodes.append(write("listener", SLOW.replace("QOS", qos).replace("DEPTH", "3")))
    ours = simulated(nodes, Slow("/listener", callback="on_scan", by=1.5))
    with control(bears=0.3):
        for node in nodes:
            real.start(node, SLOW="1.5")
        real.wait_for(1)
        assert ours == real.lines() == [": 1 18 19 20"]


# --- what comes late --------------------------------------------------------------------------------------------------

STEADY = """
    publisher = node.create_publisher(UInt32, "scan", QoSProfile(depth=100, reliability=QOS))
    spin_until(lambda: publisher.get_subscription_count() == 1)
    spin_for(1.0)
    for number in range(1, 41):
        publisher.publish(UInt32(data=number))
        spin_for(0.05)
    spin_for(5.0)
"""
ORDER = """
    heard = []

    def on_scan(message):
        heard.append(message.data)
        if len(heard) == 5:
            say(":", "five")

    node.create_subscription(UInt32, "scan", on_scan, QoSProfile(depth=100, reliability=QOS))
    spin_until(lambda: heard and heard[-1] == 40)
    say(":", "lost none, in order:", heard == list(range(1, 41)))
"""


def test_a_reliable_topic_delays_and_loses_nothing(real: Started, write: Callable[[str, str], Path]) -> None:
    """The reader's process is stopped meanwhile: what was sent comes later, all of it, in order."""
    nodes = [write("talker", STEADY.replace("QOS", "reliable")), write("listener", ORDER.replace("QOS", "reliable"))]
    ours = simulated(nodes, Topic("/scan", delay=(0.0, 0.8)))
    _, listener = [real.start(node) for node in nodes]
    real.wait_for(1)
    listener.send_signal(signal.SIGSTOP)
    time.sleep(0.8)
    listener.send_signal(signal.SIGCONT)
    real.wait_for(2)
    assert ours == real.lines() == [": five", ": lost none, in order: True"]


LATE_TALKER = """
    qos = QoSProfile(depth=3, durability=DurabilityPolicy.QOS)
    publisher = node.create_publisher(UInt32, "scan", qos)
    spin_for(0.6)
    for number in range(1, 6):
        publisher.publish(UInt32(data=number))
    say(":", "published")
    spin_until(lambda: publisher.get_subscription_count() == 1)
    spin_for(4.0)
"""
LATE_LISTENER = """
    heard = []
    qos = QoSProfile(depth=10, durability=DurabilityPolicy.QOS)
    subscription = node.create_subscription(UInt32, "scan", lambda message: heard.append(message.data), qos)
    spin_until(lambda: subscription.get_publisher_count() == 1)
    spin_for(1.5)
    say(":", heard)
"""


@pytest.mark.parametrize(("qos", "heard"), [("VOLATILE", []), ("TRANSIENT_LOCAL", [3, 4, 5])])
def test_who_is_found_late_hears_what_is_kept(
    real: Started, write: Callable[[str, str], Path], qos: str, heard: list[int]
) -> None:
    nodes = [write("talker", LATE_TALKER.replace("QOS", qos)), write("listener", LATE_LISTENER.replace("QOS", qos))]
    ours = simulated(nodes, Late("/listener", 1.0))
    real.start(nodes[0])
    real.wait_for(1)
    real.start(nodes[1])
    real.wait_for(2)
    assert ours == real.lines() == [": published", f": {heard}"]


# --- who dies ---------------------------------------------------------------------------------------------------------

MORTAL = """
    publisher = node.create_publisher(UInt32, "scan", 10)
    spin_until(lambda: publisher.get_subscription_count() == 1)
    spin_for(0.5)
    number = 0
    while True:
        number += 1
        publisher.publish(UInt32(data=number))
        spin_for(0.1)
"""
WITNESS = """
    heard = []

    def on_scan(message):
        heard.append(message.data)
        if len(heard) == 5:
            say(":", "five")

    node.create_subscription(UInt32, "scan", on_scan, 10)
    before = -1
    spin_until(lambda: len(heard) >= 5)
    while len(heard) != before:
        before = len(heard)
        spin_for(2.0)
    say(":", "in order:", heard == list(range(heard[0], heard[0] + len(heard))))
    say(":", "still counted:", node.count_publishers("scan"), node.get_node_names())
"""


def test_nobody_is_told_of_a_killed_process(real: Started, write: Callable[[str, str], Path]) -> None:
    nodes = [write("talker", MORTAL), write("witness", WITNESS)]
    ours = simulated(nodes, Crash("/talker", at=2.0))
    talker, _ = [real.start(node) for node in nodes]
    real.wait_for(1)
    talker.kill()
    real.wait_for(3)
    assert [sorted(line) for line in ours] == [sorted(line) for line in real.lines()]
    assert ours[:2] == [": five", ": in order: True"] and "counted: 1" in ours[2]


# --- ROS 1 ------------------------------------------------------------------------------------------------------------

TALKER_1 = """
    import rospy
    from std_msgs.msg import UInt32

    rospy.init_node("talker")
    publisher = rospy.Publisher("scan", UInt32, queue_size=100)
    while publisher.get_num_connections() < 1:
        rospy.sleep(0.05)
    rospy.sleep(0.5)
    for number in range(1, 41):
        publisher.publish(number)
        rospy.sleep(0.05)
        if publisher.get_num_connections() < 1:
            print(": the listener has gone", flush=True)
            break
    rospy.sleep(5.0)
"""
LISTENER_1 = """
    import rospy
    from std_msgs.msg import UInt32

    heard = []

    def on_scan(message):
        heard.append(message.data)
        if len(heard) == 5:
            print(": five", flush=True)

    rospy.init_node("listener")
    rospy.Subscriber("scan", UInt32, on_scan)
    while not heard or heard[-1] < 40:
        rospy.sleep(0.05)
    print(": lost none, in order:", heard == list(range(1, 41)), flush=True)
"""


@pytest.fixture
def nodes_1(tmp_path: Path) -> list[Path]:
    nodes = [tmp_path / "talker1.py", tmp_path / "listener1.py"]
    for node, text in zip(nodes, (TALKER_1, LISTENER_1), strict=True):
        node.write_text(dedent(text), encoding="utf-8")
    return nodes


@pytest.fixture
def real_1(require: Callable[[str], None], leaves_nothing: Path) -> Iterator[Started]:
    require("ros1")
    with ros1.Workspace() as workspace:
        workspace.start_master()
        yield Started(workspace, ["python3"])


def test_tcp_delays_and_keeps_the_order(real_1: Started, nodes_1: list[Path]) -> None:
    ours = simulated(nodes_1, Topic("/scan", delay=(0.0, 0.8)))
    _, listener = [real_1.start(node) for node in nodes_1]
    real_1.wait_for(1)
    listener.send_signal(signal.SIGSTOP)
    time.sleep(0.8)
    listener.send_signal(signal.SIGCONT)
    real_1.wait_for(2)
    assert ours == real_1.lines() == [": five", ": lost none, in order: True"]


def test_the_others_see_at_once_that_a_connection_of_ros_1_breaks(real_1: Started, nodes_1: list[Path]) -> None:
    ours = simulated(nodes_1, Crash("/listener", at=1.5))
    _, listener = [real_1.start(node) for node in nodes_1]
    real_1.wait_for(1)
    listener.kill()
    real_1.wait_for(2)
    assert sorted(ours) == sorted(real_1.lines()) == [": five", ": the listener has gone"]


# --- the clock --------------------------------------------------------------------------------------------------------

# Stands before the C library's, and sets the time of day for the one process that asks it to. The kernel's stays as it
# is, so who waits for a time of day should wait for that one. A monotonic time is known by being small.
SHIM = """
    #define _GNU_SOURCE
    #include <dlfcn.h>
    #include <pthread.h>
    #include <time.h>

    static volatile long long ahead;

    void set_ahead(long long ns) { ahead = ns; }

    int clock_gettime(clockid_t id, struct timespec *time) {
        static int (*real)(clockid_t, struct timespec *);
        if (!real) real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
        int status = real(id, time);
        if (id == CLOCK_REALTIME && ahead) {
            long long ns = time->tv_sec * 1000000000LL + time->tv_nsec + ahead;
            time->tv_sec = ns / 1000000000LL;
            time->tv_nsec = ns % 1000000000LL;
        }
        return status;
    }

    int pthread_cond_timedwait(pthread_cond_t *cond, pthread_mutex_t *mutex, const struct timespec *until) {
        static int (*real)(pthread_cond_t *, pthread_mutex_t *, const struct timespec *);
        if (!real)
            real = (int (*)(pthread_cond_t *, pthread_mutex_t *, const struct timespec *))dlsym(
                RTLD_NEXT, "pthread_cond_timedwait");
        struct timespec kernel = *until;
        if (until->tv_sec > 1000000000LL) {
            long long ns = until->tv_sec * 1000000000LL + until->tv_nsec - ahead;
            kernel.tv_sec = ns / 1000000000LL;
            kernel.tv_nsec = ns % 1000000000LL;
        }
        return real(cond, mutex, &kernel);
    }
"""
SET = """
    import ctypes, os, threading, time

    count, last = 0, time.monotonic()

    def set_clock():
        if "SET" in os.environ:
            ctypes.CDLL(os.environ["LD_PRELOAD"]).set_ahead(ctypes.c_longlong(int(os.environ["SET"])))

    def tick(*event):
        global count, last
        count, now = count + 1, time.monotonic()
        print(f": {count} {now - last:.2f}", flush=True)
        last = now
        if count == 5:
            threading.Timer(0.1, set_clock).start()
"""
TIMERS = {
    1: """
    import rospy
    rospy.init_node("node")
    rospy.Timer(rospy.Duration(0.2), tick)
    rospy.spin()
    """,
    2: """
    import rclpy
    rclpy.init()
    node = rclpy.create_node("node")
    node.create_timer(0.2, tick)
    rclpy.spin(node)
    """,
}


@pytest.mark.parametrize("by", [-0.5, 0.5])
@pytest.mark.parametrize("ros", [1, 2])
def test_a_timer_when_the_clock_is_set(
    require: Callable[[str], None],
    leaves_nothing: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    ros: int,
    by: float,
) -> None:
    """rospy's sleeps on; rclpy's waits until its time comes again, and follows the new grid."""
    require(f"ros{ros}")
    if not (compiler := shutil.which("cc")):
        pytest.skip("there is no C compiler")
    source, shim, node = tmp_path / "shim.c", tmp_path / "shim.so", tmp_path / "node.py"
    source.write_text(dedent(SHIM), encoding="utf-8")
    subprocess.run([compiler, "-shared", "-fPIC", "-o", shim, source, "-ldl"], check=True)
    node.write_text(dedent(SET) + dedent(TIMERS[ros]), encoding="utf-8")
    ours = _gaps(rosspin.simulate(node, 3.5, faults=[ClockJump(at=1.1, by=by)]).console)
    monkeypatch.setenv("LD_PRELOAD", os.fspath(shim))
    monkeypatch.setenv("SET", str(int(by * 1e9)))
    with control(bears=0.05):
        run = launch(node, 4.0) if ros == 2 else ros1.launch(node, 4.0)
        real = _gaps(run.console)
        assert [round(gap, 1) for gap in real[4:11]] == pytest.approx([round(gap, 1) for gap in ours[4:11]], abs=0.11)
        assert (max(ours) > 0.6) == (max(real[1:]) > 0.6) == (ros == 2 and by < 0)


def _gaps(console: str) -> list[float]:
    return [float(line.split()[2]) for line in console.splitlines() if line.startswith(": ")]
