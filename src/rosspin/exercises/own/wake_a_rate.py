"""A Rate needs no thread that spins: a belief that this reveals."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from .. import judges as by
from ..feedback import Finding
from ..judging import Answer

TITLE = "Wake a sleeping Rate"
TEXT = """
**You need**: [the Rate node in ROS 2](ros2-rate.md), and what
[How timing works in ROS 2](../docs/ros2/how-timing-works.rst) says of a Rate.

This loop should make a pass every 0.5 s, but makes only the first. Repair the node so that

- a pass begins every 0.5 s, whether its work takes 0.1 s or longer, and
- the node ends immediately, with status 0 and without a traceback, at Ctrl-C and at SIGTERM.
"""
REVEALS = "A Rate needs no thread that spins. Ctrl-C wakes every thread that sleeps."

NODE = """
import time

import rclpy
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.work = self.declare_parameter("work", 0.1).value

    def loop(self):
        loop_rate = self.create_rate(2.0)
        counter = 0
        while rclpy.ok():
            counter += 1
            self.get_logger().info("[SPINNER PY NODE] counter = " + str(counter))
            time.sleep(self.work)
            loop_rate.sleep()


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    spinner_py_node.loop()
    rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "A Rate of ROS 2 is a timer, whose callback wakes the thread that sleeps on the Rate. What calls it here?",
    "You need a thread that sleeps and a thread that spins. `threading.Thread(target=..., "
    "daemon=True).start()` starts one.",
    "A signal ends `rclpy.spin` in the main function, but does not wake a Rate. So run the loop in "
    "the second thread. What does `spin` raise at Ctrl-C, and what at SIGTERM?",
]
HINT = "A Rate is a timer that wakes the thread in `sleep()`: while one thread sleeps, another has to spin."


def check(answer: Answer) -> Iterator[Finding]:
    """Whether a loop of 2 Hz makes its passes, and the node ends well by either signal."""
    endings = []
    for work, seconds in ((0.1, 3.3), (0.4, 3.05)):
        when = f"With `work:={work}`"
        run = answer.run(seconds, f"work:={work}", has_to_end=False)
        counters = run.counters()
        hint = ""
        if len(counters) == 1 and run.interrupted:
            hint = "The first `sleep()` never returned. A Rate is a timer: who calls it back while the loop sleeps?"
        elif len(counters) > 1 and abs(counters[1].time - 0.5 - work) < by.CLOSE:
            hint = "The work is a part of the period: shorten the pause by the time that the work takes."
        elif counters and counters[0].time > by.CLOSE:
            hint = "The first pass begins immediately: the loop sleeps at its end, and a timer would wait for a period."
        elif len(counters) > 1 and work > 0.1 and abs(counters[1].time - 0.4 - work) < by.CLOSE:
            hint = "The pause is the same whatever the work takes. Make it as long as what is left of the period."
        elif len(counters) > 1 and abs(counters[1].time - 0.5) > 0.05:
            hint = "A Rate is given a frequency. Passes every 0.5 s are 2.0 a second."
        finding = by.on_time(counters, by.grid(0.5, seconds, start=0.0), when, hint)
        yield finding
        endings.append(by.ends_well(run, f"{when}, Ctrl-C"))
        if not finding.right or run.killed:
            yield from endings
            return
    long = answer.run(3.3, "work:=0.8", has_to_end=False).counters()
    if any(after.time - line.time < 0.8 - by.CLOSE for line, after in pairwise(long)):
        text = "With `work:=0.8`: a pass began less than 0.8 s after the one before it, which should have been at work."
        yield Finding(False, text, "Each pass works, with `time.sleep(self.work)`, before it sleeps.")
        return
    # SIGTERM first: if the loop is in the main part, catching exceptions there does not help.
    yield from by.ending(6.3, by.ends_at_sigterm(3.3), when="SIGTERM", terminated_at=3.3)(answer)
    yield from endings
    yield from by.shaken(2, 3.3, by.ticks(0.5, start=0.0))(answer)


SOLUTION = {
    "import time\n": "import threading\nimport time\n",
    "import rclpy\n": "import rclpy\nfrom rclpy.executors import ExternalShutdownException\n",
    "    spinner_py_node.loop()\n    rclpy.try_shutdown()\n": "    threading.Thread("
    "target=spinner_py_node.loop, daemon=True).start()\n"
    "    try:\n"
    "        rclpy.spin(spinner_py_node)\n"
    "    except (KeyboardInterrupt, ExternalShutdownException):\n"
    "        pass\n",
}
AFTER = """
You often see the loop in the main function, and a thread that spins. SIGTERM does not end such a node, and what Ctrl-C
does is left to chance.
"""

SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
THREAD = "    threading.Thread(target=spinner_py_node.loop, daemon=True).start()\n"
SPIN_CAUGHT = f"    try:\n{SPIN}{CAUGHT}"
LOOP = """        loop_rate = self.create_rate(2.0)
        counter = 0
        while rclpy.ok():
            counter += 1
            self.get_logger().info("[SPINNER PY NODE] counter = " + str(counter))
            time.sleep(self.work)
            loop_rate.sleep()
"""
SLEEPS = "            loop_rate.sleep()\n"
SPINNING_THREAD = "    threading.Thread(target=rclpy.spin, args=(spinner_py_node,), daemon=True).start()\n"
IN_MAIN = {
    SPIN: "        spinner_py_node.loop()\n",
    THREAD: """    def spin():
        try:
            rclpy.spin(spinner_py_node)
        except ExternalShutdownException:
            pass
    threading.Thread(target=spin, daemon=True).start()
""",
}

RIGHT = [
    {SPIN_CAUGHT: f"    try:\n{SPIN}{CAUGHT}    finally:\n        rclpy.try_shutdown()\n"},
    {
        THREAD: THREAD + "    executor = rclpy.executors.SingleThreadedExecutor()\n"
        "    executor.add_node(spinner_py_node)\n",
        SPIN: "        executor.spin()\n",
        "import rclpy\n": "import rclpy\nimport rclpy.executors\n",
    },
    # A loop that sleeps on the clock needs no thread that spins.
    {
        THREAD: "",
        SPIN: "        spinner_py_node.loop()\n",
        LOOP: """        due = self.get_clock().now()
        counter = 0
        while rclpy.ok():
            counter += 1
            self.get_logger().info("[SPINNER PY NODE] counter = " + str(counter))
            time.sleep(self.work)
            due += rclpy.duration.Duration(seconds=0.5)
            self.get_clock().sleep_until(due)
""",
        "import rclpy\n": "import rclpy\nimport rclpy.duration\n",
    },
    # The loop itself calls the timer of its Rate.
    {SLEEPS: "            rclpy.spin_once(self)\n" + SLEEPS, THREAD: "", SPIN: "        spinner_py_node.loop()\n"},
    # A timer, whose first call is made by hand.
    {
        THREAD: "    spinner_py_node.loop()\n",
        LOOP: """        self.counter = 0
        self.create_timer(0.5, self.one_pass)
        self.one_pass()

    def one_pass(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))
        time.sleep(self.work)
""",
    },
    # The loop spins for as long as is left of the period.
    {
        THREAD: "",
        SPIN: "        spinner_py_node.loop()\n",
        LOOP: """        start = time.monotonic()
        counter = 0
        while rclpy.ok():
            counter += 1
            self.get_logger().info("[SPINNER PY NODE] counter = " + str(counter))
            time.sleep(self.work)
            while (left := start + 0.5 * counter - time.monotonic()) > 0 and rclpy.ok():
                rclpy.spin_once(self, timeout_sec=left)
""",
    },
    {
        "rclpy.spin(spinner_py_node)": "rclpy.spin(spinner_py_node, rclpy.executors.MultiThreadedExecutor())",
        "import rclpy\n": "import rclpy\nimport rclpy.executors\n",
    },
]
WRONG = [
    (
        {"            time.sleep(self.work)\n": ""},
        "a pass began less than 0.8 s after the one before it",
        "Each pass works",
    ),
    (
        {THREAD: "", SPIN: "        spinner_py_node.loop()\n"},
        "counter 2, due at 0.5 s, did not come",
        "The first `sleep()` never returned",
    ),
    (
        {THREAD: SPINNING_THREAD, SPIN: "        spinner_py_node.loop()\n"},
        "Ctrl-C: the thread stopped with `rclpy.executors.ExternalShutdownException`",
        "The main part should spin",
    ),
    (IN_MAIN, "SIGTERM at 3.3 s: the node did not end", "The main part should spin"),
    (
        {SPIN_CAUGHT: "    rclpy.spin(spinner_py_node)\n"},
        "Ctrl-C: the node stopped in line 28: `KeyboardInterrupt`",
        "Catch both around `spin`",
    ),
    (
        {"(KeyboardInterrupt, ExternalShutdownException)": "KeyboardInterrupt"},
        "SIGTERM: the node stopped in line 29:",
        "Catch both around `spin`",
    ),
    (
        {"(KeyboardInterrupt, ExternalShutdownException)": "ExternalShutdownException"},
        "Ctrl-C: the node stopped in line 29: `KeyboardInterrupt`",
        "Catch both",
    ),
    ({SPIN_CAUGHT: f"{SPIN_CAUGHT}    rclpy.shutdown()\n"}, "RCLError", "`rclpy.try_shutdown()` does not"),
    ({SLEEPS: "            time.sleep(0.5)\n"}, "With `work:=0.1`: counter 2 came at 0.6 s", "shorten the pause"),
    (
        {SLEEPS: "            time.sleep(0.4)\n"},
        "With `work:=0.4`: counter 2 came at 0.8 s, not at 0.5 s",
        "The pause is the same whatever the work takes.",
    ),
    (
        {"create_rate(2.0)": "create_rate(0.5)"},
        "counter 2 came at 2 s, not at 0.5 s",
        "A Rate is given a frequency.",
    ),
    (
        {"daemon=True": "daemon=False"},
        "With `work:=0.1`, Ctrl-C: the node did not end: one of its threads was still asleep in a Rate's `sleep()`",
        "Use a Rate only in a daemon thread",
    ),
    # The same, in a thread of an executor.
    (
        {
            THREAD: "    spinner_py_node.create_timer(0.001, spinner_py_node.loop)\n",
            "rclpy.spin(spinner_py_node)": "rclpy.spin(spinner_py_node, rclpy.executors.MultiThreadedExecutor())",
            "import rclpy\n": "import rclpy\nimport rclpy.executors\n",
        },
        "asleep in a Rate's `sleep()`",
        "Use a Rate only in a daemon thread",
    ),
    # A daemon thread is asleep, too, but something else does not end.
    (
        {SPIN_CAUGHT: SPIN_CAUGHT + "    while True:\n        time.sleep(1.0)\n"},
        "the node did not end: it was still in line 33, `time.sleep(1.0)`. Does its loop ask `rclpy.ok()`?",
        "wakes the thread in `sleep()`",
    ),
    ({SPIN_CAUGHT: "    pass\n"}, "counter 2, due at 0.5 s, did not come", "The node ended by itself"),
    (
        {"target=spinner_py_node.loop,": "target=spinner_py_node.loop(),"},
        "counter 2, due at 0.5 s",
        "never returned",
    ),
    (
        {
            THREAD: "",
            LOOP: LOOP.replace(
                "        loop_rate", "        self.create_timer(0.5, self.one_pass)\n        loop_rate", 1
            ),
        },
        "no counter was printed",
        "wakes the thread in `sleep()`",
    ),
]
