"""Random nodes with threads give the same bytes run after run: alone, and beside another process."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.seeds import SEED
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

NODES = 100
SECONDS = 1.5

# What a callback, a thread or the main may do; {n} is its number, {t} a time in seconds.
_STATEMENTS = (
    "time.sleep({t})",
    "sleep({t})",
    "make_rate(1 / {t}).sleep()",
    "with lock: say({n}, 'in the lock'); time.sleep({t})",
    "with rlock, rlock: say({n}, 'in the rlock'); time.sleep({t})",
    "say({n}, 'lock', lock.acquire(timeout={t}) and lock.release())",
    "with condition: say({n}, 'notified', condition.wait({t}))",
    "with condition: condition.notify_all()",
    "say({n}, 'event', event.wait({t})); event.clear()",
    "event.set()",
    "with semaphore: time.sleep({t})",
    "put({n}, {t})",
    "get({n}, {t})",
    "say({n}, 'future', pool.submit(work, {n}, {t}).result())",
    "pool.submit(work, {n}, {t})",
    "publisher.publish(Int64(data={n}))",
    "threading.Timer({t}, say, ({n}, 'timer')).start()",
    "threading.Thread(target=work, args=({n}, {t}), daemon=True).start()",
    "log('%s %s', threading.current_thread().name, {{'a', 'b', 'c'}} - {{'b'}} == {{'c', 'a'}})",
    "say({n}, sorted(thread.name for thread in threading.enumerate()))",
    "1 / 0",
)

_NODE = '''"""Made at random."""
import concurrent.futures, pathlib, queue, threading, time

lock, rlock, condition = threading.Lock(), threading.RLock(), threading.Condition()
event, semaphore, values = threading.Event(), threading.Semaphore(2), queue.Queue(2)
pool = concurrent.futures.ThreadPoolExecutor(2)


def say(*words):
    print(now(), threading.current_thread().name, *words)


def work(number, seconds):
    time.sleep(seconds)
    say(number, "worked")
    return number


def put(number, seconds):
    try:
        say(number, "put", values.put(number, timeout=seconds))
    except queue.Full:
        say(number, "full")


def get(number, seconds):
    try:
        say(number, "got", values.get(timeout=seconds))
    except queue.Empty:
        say(number, "empty")


def hear(message):
    say("heard", message.data)


'''

# The same names for what each ROS has.
_OF_ROS = {
    1: """import rospy
from std_msgs.msg import Int64

rospy.init_node(pathlib.Path(__file__).stem)
now, sleep, log, make_rate = rospy.get_time, rospy.sleep, rospy.loginfo, rospy.Rate
publisher = rospy.Publisher("numbers", Int64, queue_size=3)
rospy.Subscriber("numbers", Int64, hear)


def ok():
    return not rospy.is_shutdown()


def every(period, callback, oneshot):
    rospy.Timer(rospy.Duration(period), callback, oneshot=oneshot)


""",
    2: """import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_msgs.msg import Int64

rclpy.init()
node = rclpy.create_node(pathlib.Path(__file__).stem)
sleep, make_rate, ok, group = time.sleep, node.create_rate, rclpy.ok, ReentrantCallbackGroup()
publisher = node.create_publisher(Int64, "numbers", 3)
node.create_subscription(Int64, "numbers", hear, 3)
threading.Thread(target=rclpy.spin, args=(node, MultiThreadedExecutor(3)), daemon=True).start()


def now():
    return node.get_clock().now().nanoseconds


def log(form, *words):
    node.get_logger().info(form % words)


def every(period, callback, oneshot):
    def call():
        if oneshot:
            timer.cancel()
        callback(None)

    timer = node.create_timer(period, call, group)


""",
}


def _random_node(draw: random.Random, ros: int) -> str:
    """The text of a node: timers, threads with loops, and a loop in the main."""
    text = _NODE + _OF_ROS[ros]

    def statements(number: int) -> str:
        return "".join(
            "    " + draw.choice(_STATEMENTS).format(n=number, t=draw.choice((0.1, 0.125, 0.25, 0.3, 0.5, 0.7))) + "\n"
            for _ in range(draw.randint(1, 4))
        )

    number = 0
    for _ in range(draw.randint(1, 3)):
        number += 1
        period = draw.choice((0.1, 0.25, 0.3, 0.5))
        text += f"def callback{number}(event):\n    say({number}, 'tick')\n{statements(number)}"
        text += f"every({period}, callback{number}, {draw.random() < 0.2})\n"
    for _ in range(draw.randint(1, 3)):
        number += 1
        body = statements(number).replace("    ", "        ")
        text += f"def loop{number}():\n    rate = make_rate({draw.choice((2, 4, 5, 10))})\n"
        text += f"    while ok():\n{body}        rate.sleep()\n"
        text += f"threading.Thread(target=loop{number}, daemon={draw.random() < 0.5}).start()\n"
    text += f"rate = make_rate(4)\nwhile ok():\n{statements(0)}    rate.sleep()\n"
    return text


# Each run's console, ticks and status, as a process of its own sees them.
_RUN_ALL = """
import json, sys
from rosspin import simulate
seconds, *all = json.loads(sys.argv[1])
runs = [simulate(paths[0] if len(paths) == 1 else paths, seconds) for paths in all]
print(json.dumps([[run.console, [tick._asdict() for tick in run.ticks], run.status] for run in runs]))
"""


@pytest.mark.parametrize("kinds", [(1,), (2,), (1, 1), (2, 2), (2, 1)])
def test_the_same_nodes_give_the_same_bytes(tmp_path: Path, kinds: tuple[int, ...]) -> None:
    """Whatever ran before them in the process, and also where sets keep their elements in another order."""
    draw = random.Random(SEED)
    runs = []
    for number in range(NODES // len(kinds) ** 2):
        runs.append([tmp_path / f"node{number}_{each}.py" for each in range(len(kinds))])
        for path, ros in zip(runs[-1], kinds, strict=True):
            path.write_text(_random_node(draw, ros))
    first, second = _run_all(runs, "1"), _run_all(runs[::-1], "2")
    for paths, one, other in zip(runs, first, second[::-1], strict=True):
        assert one == other, "\n".join(path.read_text() for path in paths)
    assert sum(len(run[1]) for run in first) > len(runs)  # ticks
    assert len(kinds) == 1 or sum("heard" in run[0] for run in first) > len(runs) / 4


def _run_all(runs: list[list[Path]], hash_seed: str) -> Any:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src"), "PYTHONHASHSEED": hash_seed}
    given = json.dumps([SECONDS, *([str(path) for path in paths] for paths in runs)])
    command = [sys.executable, "-c", _RUN_ALL, given]
    return json.loads(subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout)
