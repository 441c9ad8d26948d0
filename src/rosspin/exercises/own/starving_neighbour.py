"""Timers of one node do not disturb each other: a belief that this reveals."""

from __future__ import annotations

from functools import partial
from itertools import pairwise

from .. import judges as by
from ..feedback import Finding
from ..judging import plain, say
from ..observed import ObservedRun

TITLE = "Free a starving neighbour"
TEXT = """
**You need**: [which executor lets both timers keep their times](ros2-executors.md).

This node takes an image every second, which needs 0.6 s, and sends the motor a command every 0.1 s. But the motor
gets no commands while an image is being taken. Repair the node so that

- the motor gets its command every 0.1 s, whatever the camera does, and
- the camera takes images as before, one after the other.
"""
REVEALS = (
    "Timers of one node do not disturb each other. A MultiThreadedExecutor alone lets callbacks run at the same time."
)

NODE = """
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.takes = self.declare_parameter("takes", 0.6).value
        self.images = 0
        self.commands = 0
        self.create_timer(1.0, self.camera_callback)
        self.create_timer(0.1, self.motor_callback)

    def camera_callback(self):
        self.images += 1
        self.get_logger().info("[CAMERA] image = " + str(self.images))
        time.sleep(self.takes)
        self.get_logger().info("[CAMERA] done = " + str(self.images))

    def motor_callback(self):
        self.commands += 1
        self.get_logger().info("[MOTOR] counter = " + str(self.commands))


def main():
    rclpy.init()
    robot_py_node = RobotPyNode()
    try:
        rclpy.spin(robot_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "`rclpy.spin` calls all callbacks in one thread. A `MultiThreadedExecutor`, from "
    "`rclpy.executors`, has several. Is that enough?",
    "The timers of a node are in one callback group, in which no two callbacks run at the same "
    "time. `create_timer` takes another group as `callback_group`.",
    "`rclpy.callback_groups` has two kinds. In a `ReentrantCallbackGroup` the camera could take two "
    "images at the same time; a `MutuallyExclusiveCallbackGroup` for each timer prevents that.",
]
_STARVED = (
    "While the camera's callback runs, a single-threaded executor calls nothing, and no executor calls what is in the "
    "same mutually exclusive group. A node's timers are in one such group unless you give them others."
)
_COMMANDED = by.ticks(0.1, "the motor", "MOTOR", by.unless_regular(0.1, _STARVED))
HINT = "It takes two things: a `MultiThreadedExecutor`, and a callback group of its own for each timer."


def _one_image_at_a_time(run: ObservedRun, when: str, takes: float) -> Finding:
    """Whether the camera takes its images one after the other, each in its time, as often as that allows."""
    begun = [line for line in run.values("CAMERA", "image") if line.time <= run.seconds]
    done = run.values("CAMERA", "done")
    what = f"{when}, the camera"
    least = 5 if takes < 1 else 3
    if len(begun) < least:
        text = f"{what} took {len(begun)} images in {say(run.seconds)}; it can take {least}."
        return Finding(False, text, "The camera has to work as before: every second, or as often as its work allows.")
    for image, later in pairwise(begun):
        if not any(image.time <= line.time <= later.time for line in done):
            text = f"{what} began image {later.text} at {say(later.time)}, while it still took image {image.text}."
            reentrant = (
                "In a `ReentrantCallbackGroup` calls of one timer may overlap; in the other kind they may not. And a "
                "callback that returns too soon is called again."
            )
            return Finding(False, text, reentrant)
    for number, image in enumerate(begun, 1):
        end = next((line for line in done if line.text == image.text), None)
        if image.text != str(number):
            return Finding(False, f"{what}: where image {number} was due, image {plain(image.text)} began.")
        if image.time + takes > run.seconds:
            continue
        if end is None or abs(end.time - image.time - takes) > by.CLOSE:
            after = f"done after {say(end.time - image.time)}" if end else "never done"
            text = f"{what}: image {number} was {after}, not after {say(takes)}."
            return Finding(False, text, "Leave the time that an image takes as it is.")
    if takes < 1 and (late := [line for n, line in enumerate(begun, 1) if abs(line.time - n) > by.CLOSE]):
        text = f"{what} began image {late[0].text} at {say(late[0].time)}, not at {say(float(late[0].text))}."
        return Finding(False, text, "The camera has to work as before: every second.")
    return Finding(True, f"{what} took {len(begun)} images, one after the other.")


def _returns_to_its_times(run: ObservedRun, when: str) -> Finding | None:
    """Whether the motor's commands are on time again after nothing ran for a while. Nothing is said if they are."""
    late = [line.time for line in run.counters("MOTOR") if line.time > 2.3]
    off = [time for time in late if abs(10 * time - round(10 * time)) > 10 * by.CLOSE]
    if late and not off:
        return None
    came = f"one came at {say(off[0])}" if off else "none came after that"
    text = f"when the computer was busy from 1.23 s to 2.16 s, the motor's commands left their times: {came}."
    sleeps = "A loop that sleeps for 0.1 s counts from when it was woken. A timer goes back to its times."
    return Finding(False, text, sleeps)


_QUICK = partial(_one_image_at_a_time, takes=0.6)

check = by.until_wrong(
    by.run(5.0, _COMMANDED, _QUICK, given="takes:=0.6"),
    by.run(5.0, _COMMANDED, partial(_one_image_at_a_time, takes=1.3), given="takes:=1.3"),
    by.shaken(2, 5.0, _COMMANDED, _QUICK, given="takes:=0.6"),
    by.run(3.0, _returns_to_its_times, given="takes:=0.6", stalls_at=1.234),
)

SOLUTION = {
    "from rclpy.executors import ExternalShutdownException\n": "from rclpy.callback_groups import "
    "MutuallyExclusiveCallbackGroup\n"
    "from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor\n",
    "        self.create_timer(1.0, self.camera_callback)\n"
    "        self.create_timer(0.1, self.motor_callback)\n": "        self.create_timer(1.0, "
    "self.camera_callback, MutuallyExclusiveCallbackGroup())\n"
    "        self.create_timer(0.1, self.motor_callback, MutuallyExclusiveCallbackGroup())\n",
    "    robot_py_node = RobotPyNode()\n": "    robot_py_node = RobotPyNode()\n"
    "    executor = MultiThreadedExecutor()\n"
    "    executor.add_node(robot_py_node)\n",
    "rclpy.spin(robot_py_node": "executor.spin(",
}
AFTER = """
It is enough to give one of the two timers a group of its own. The two callbacks now run at the same time, so what both
use needs a lock: see [Share data between callbacks](../docs/how-to/shared-data.rst).
"""

CAMERA = "self.create_timer(1.0, self.camera_callback, MutuallyExclusiveCallbackGroup())"
MOTOR = "self.create_timer(0.1, self.motor_callback, MutuallyExclusiveCallbackGroup())"
ALONE = {", MutuallyExclusiveCallbackGroup())": ")"}
EXECUTOR = "    executor = MultiThreadedExecutor()\n    executor.add_node(robot_py_node)\n"
SPINS = "        executor.spin()\n"
WORK = """    def camera_callback(self):
        self.images += 1
        self.get_logger().info("[CAMERA] image = " + str(self.images))
        time.sleep(self.takes)
        self.get_logger().info("[CAMERA] done = " + str(self.images))
"""

RIGHT = [
    {MOTOR: "self.create_timer(0.1, self.motor_callback)"},
    {CAMERA: "self.create_timer(1.0, self.camera_callback)"},
    {"MultiThreadedExecutor()": "MultiThreadedExecutor(num_threads=2)"},
    {
        MOTOR: "self.create_timer(0.1, self.motor_callback, callback_group=ReentrantCallbackGroup())",
        "import MutuallyExclusiveCallbackGroup": "import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup",
    },
    {EXECUTOR: "    executor = MultiThreadedExecutor()\n", SPINS: "        rclpy.spin(robot_py_node, executor)\n"},
    # The images are taken by a thread, of which the callback starts one at a time.
    {
        **ALONE,
        EXECUTOR: "",
        SPINS: "        rclpy.spin(robot_py_node)\n",
        WORK: """    def camera_callback(self):
        if self.images == 0 or not self.thread.is_alive():
            self.thread = threading.Thread(target=self.take, daemon=True)
            self.thread.start()

"""
        + WORK.replace("camera_callback", "take"),
        "import time\n": "import threading\nimport time\n",
    },
    # Two nodes, each with an executor and a thread.
    """import threading, time
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
rclpy.init()
camera, motor = rclpy.create_node("camera"), rclpy.create_node("motor")
takes = camera.declare_parameter("takes", 0.6).value
counts = {"image": 0, "counter": 0}
def take():
    counts["image"] += 1
    print(f"[CAMERA] image = {counts['image']}")
    time.sleep(takes)
    print(f"[CAMERA] done = {counts['image']}")
def drive():
    counts["counter"] += 1
    print(f"[MOTOR] counter = {counts['counter']}")
camera.create_timer(1.0, take)
motor.create_timer(0.1, drive)
def spin():
    executor = SingleThreadedExecutor()
    executor.add_node(camera)
    try:
        executor.spin()
    except ExternalShutdownException:
        pass
threading.Thread(target=spin, daemon=True).start()
rclpy.spin(motor)
""",
]
WRONG = [
    (
        {
            **ALONE,
            EXECUTOR: "    threading.Thread(target=robot_py_node.drive, daemon=True).start()\n",
            SPINS: "        rclpy.spin(robot_py_node)\n",
            "        self.create_timer(0.1, self.motor_callback)\n": "",
            "    def motor_callback": "    def drive(self):\n        while rclpy.ok():\n            time.sleep(0.1)\n"
            "            self.motor_callback()\n\n    def motor_callback",
            "import time\n": "import threading\nimport time\n",
        },
        "the motor's commands left their times: one came at 2.364",
        "A loop that sleeps for 0.1 s counts from when it was woken.",
    ),
    (
        {EXECUTOR: "", SPINS: "        rclpy.spin(robot_py_node)\n"},
        "With `takes:=0.6`, the motor: counter 10 came at 1.6 s",
        "a single-threaded executor",
    ),
    (ALONE, "With `takes:=0.6`, the motor: counter 1", "in the same mutually exclusive group"),
    (
        {"MultiThreadedExecutor": "SingleThreadedExecutor"},
        "the motor: counter 10 came at 1.6 s",
        "single-threaded executor",
    ),
    (
        {"MutuallyExclusive": "Reentrant"},
        "With `takes:=1.3`, the camera began image 2 at 2 s, while it still took image 1",
        "calls of one timer may overlap",
    ),
    (
        {
            "        self.create_timer(1.0": "        group = MutuallyExclusiveCallbackGroup()\n"
            "        self.create_timer(1.0",
            ", MutuallyExclusiveCallbackGroup())": ", group)",
        },
        "the motor: counter 1",
        "in the same mutually exclusive group",
    ),
    (
        {"time.sleep(self.takes)": "pass"},
        "image 1 was done after 0 s, not after 0.6 s",
        "the time that an image takes",
    ),
    (
        {"time.sleep(self.takes)": "time.sleep(0.05)"},
        "done after 0.05 s, not after 0.6 s",
        "the time that an image takes",
    ),
    (
        {"time.sleep(self.takes)": "time.sleep(0.6)"},
        "With `takes:=1.3`, the camera: image 1 was done after 0.6 s",
        "the time that an image takes",
    ),
    ({"create_timer(1.0": "create_timer(2.0"}, "the camera took 2 images in 5 s; it can take 5", "as before"),
    (
        {MOTOR: f"{MOTOR}\n        {MOTOR}"},
        "the motor: counter 2 came at 0.1 s, not at 0.2 s",
        "They come two at a time",
    ),
    ({"create_timer(0.1": "create_timer(0.2"}, "the motor: counter 1 came at 0.2 s", "They come every 0.2 s:"),
    ({"MultiThreadedExecutor()": "MultiThreadedExecutor(1)"}, "the motor: counter 1", "single-threaded"),
    (
        {EXECUTOR: "    executor = MultiThreadedExecutor()\n"},
        "the motor: no counter was printed",
        "single-threaded",
    ),
    (
        {
            "time.sleep(self.takes)": "threading.Thread(target=time.sleep, args=(self.takes,)).start()",
            "import time\n": "import threading\nimport time\n",
        },
        "image 1 was done after 0 s",
        "the time that an image takes",
    ),
]
