"""Twenty nodes that fail in some order of events, and their mended twins: 10 of ROS 1 and 10 of ROS 2.

A line that ends in ``#-`` is of the node that fails only, one that ends in ``#+`` of its twin only.
"""

from __future__ import annotations

import re
from pathlib import Path
from textwrap import dedent
from typing import NamedTuple

from rosspin import Run


class Plant(NamedTuple):
    """A planted fault: the files of its nodes, how long they run, what they have to print, whether to be deep."""

    files: tuple[str, ...]
    prints: str  # a pattern that is to match the console
    deep: bool
    seconds: float = 1.0

    def write(self, folder: Path, mended: bool) -> list[str]:
        """Write the nodes, or their twins, and return their paths."""
        paths = []
        for number, text in enumerate(self.files):
            left = [line for line in dedent(text).splitlines() if not line.endswith("#-" if mended else "#+")]
            path = folder / f"{'mended' if mended else 'planted'}_{number}.py"
            path.write_text("\n".join(left) + "\n")
            paths.append(str(path))
        return paths

    def check(self, run: Run) -> None:
        assert re.search(self.prints, run.console, re.DOTALL), run.console[-300:]


def _ros1(text: str) -> str:
    return "import rospy, threading\nfrom std_msgs.msg import Float64, UInt32\n" + dedent(text)


def _ros2(text: str) -> str:
    head = """
    import threading
    import rclpy
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.node import Node
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import Float64, UInt32
    """
    return dedent(head) + dedent(text)


_SPIN_1 = "rospy.init_node('robot')\nnode = Robot()\nrospy.spin()\n"
_SPIN_2 = "rclpy.init()\nrclpy.spin(Robot())\n"
_MANY_2 = "rclpy.init()\nexecutor = MultiThreadedExecutor(4)\nexecutor.add_node(Robot())\nexecutor.spin()\n"

PLANTS = {
    # --- ROS 1 ---
    "ros1-lost-update": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.count = 0
                    self.lock = threading.Lock()
                    for _ in range(2):
                        rospy.Timer(rospy.Duration(0.1), self.tick)
                def tick(self, event):
                    self.count += 1  #-
                    with self.lock:  #+
                        self.count += 1  #+
                    print("count", self.count)
            """)
            + _SPIN_1,
        ),
        r"count 6\n.*count 10\n",
        deep=True,
        seconds=0.5,
    ),
    "ros1-check-then-act": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.free, self.docked = True, 0
                    self.lock = threading.Lock()
                    for name in "ab":
                        rospy.Timer(rospy.Duration(0.1), lambda event: self.dock(), oneshot=True)
                    rospy.Timer(rospy.Duration(0.5), lambda event: print("docked", self.docked))
                def dock(self):
                    with self.lock:  #+
                    if True:  #-
                        if self.free:
                            self.free = False
                            self.docked += 1
            """)
            + _SPIN_1,
        ),
        "docked 1",
        deep=True,
    ),
    "ros1-lock-order": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.map, self.pose = threading.Lock(), threading.Lock()
                    rospy.Timer(rospy.Duration(0.1), self.plan)
                    rospy.Timer(rospy.Duration(0.1), self.localise)
                def plan(self, event):
                    with self.map:
                        with self.pose:
                            pass
                def localise(self, event):
                    with self.pose:  #-
                        with self.map:  #-
                    with self.map:  #+
                        with self.pose:  #+
                            print("localised")
            """)
            + _SPIN_1,
        ),
        "(localised\n){5}",
        deep=True,
    ),
    "ros1-two-topics": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.goal = None
                    rospy.Subscriber("/goal", Float64, self.set_goal)
                    rospy.Subscriber("/go", UInt32, self.go)
                    rospy.Subscriber("/goals", Float64, lambda message: print("went to", message.data))
                def set_goal(self, message):
                    self.goal = message.data
                def go(self, message):
                    print("went to", self.goal)
            """)
            + _SPIN_1,
            _ros1("""
            rospy.init_node("commander")
            goal = rospy.Publisher("/goal", Float64, queue_size=1)
            go = rospy.Publisher("/go", UInt32, queue_size=1)
            goals = rospy.Publisher("/goals", Float64, queue_size=1)
            rospy.sleep(2.5)
            goal.publish(7.0)  #-
            go.publish(1)  #-
            goals.publish(7.0)  #+
            rospy.spin()
            """),
        ),
        r"went to 7\.0",
        deep=False,
        seconds=3.0,
    ),
    "ros1-late-connection": Plant(
        (
            _ros1("""
            rospy.init_node("listener")
            rospy.Subscriber("/goal", Float64, lambda message: print("goal", message.data))
            rospy.spin()
            """),
            _ros1("""
            rospy.init_node("talker")
            goal = rospy.Publisher("/goal", Float64, queue_size=1)  #-
            goal = rospy.Publisher("/goal", Float64, queue_size=1, latch=True)  #+
            rospy.sleep(0.5)
            goal.publish(1.0)
            rospy.spin()
            """),
        ),
        r"goal 1\.0",
        deep=False,
        seconds=2.0,
    ),
    "ros1-last-one-wins": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.speed = self.stopped = 0
                    rospy.Subscriber("/stop", UInt32, self.stop)
                    rospy.Subscriber("/speed", Float64, self.drive)
                    rospy.Timer(rospy.Duration(2.9), lambda event: print("speed", self.speed))
                def drive(self, message):
                    self.speed = message.data  #-
                    self.speed = 0.0 if self.stopped else message.data  #+
                def stop(self, message):
                    self.speed, self.stopped = 0.0, True
            """)
            + _SPIN_1,
            _ros1("""
            rospy.init_node("planner")
            speed = rospy.Publisher("/speed", Float64, queue_size=1)
            rospy.sleep(2.5)
            speed.publish(1.0)
            rospy.spin()
            """),
            _ros1("""
            rospy.init_node("button")
            stop = rospy.Publisher("/stop", UInt32, queue_size=1)
            rospy.sleep(2.5)
            stop.publish(1)
            rospy.spin()
            """),
        ),
        r"speed 0\.0",
        deep=False,
        seconds=3.0,
    ),
    "ros1-stale-reading": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.reading = 0
                    rospy.Timer(rospy.Duration(0.1), self.read)
                    rospy.Timer(rospy.Duration(0.1), self.control)  #-
                def read(self, event):
                    self.reading += 1
                    self.control(event)  #+
                def control(self, event):
                    print("by", self.reading)
            """)
            + _SPIN_1,
        ),
        "by 1\nby 2\nby 3\n",
        deep=False,
        seconds=0.3,
    ),
    "ros1-changed-while-iterating": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.poses = {1: 0.0, 2: 0.0}
                    rospy.Timer(rospy.Duration(0.1), self.add)
                    rospy.Timer(rospy.Duration(0.1), self.report)
                def add(self, event):
                    self.poses[len(self.poses) + 1] = 0.0
                def report(self, event):
                    for name in self.poses:  #-
                    for name in list(self.poses):  #+
                        pose = self.poses[name]
                    print("well")
            """)
            + _SPIN_1,
        ),
        "well",
        deep=True,
        seconds=0.5,
    ),
    "ros1-torn-pose": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.x = self.y = 0
                    self.pose = 0, 0
                    rospy.Timer(rospy.Duration(0.1), self.move)
                    rospy.Timer(rospy.Duration(0.1), self.look)
                def move(self, event):
                    self.x += 1  #-
                    self.y += 1  #-
                    self.pose = self.pose[0] + 1, self.pose[1] + 1  #+
                def look(self, event):
                    pose = self.x, self.y  #-
                    pose = self.pose  #+
                    assert pose[0] == pose[1], "torn"
            """)
            + _SPIN_1,
        ),
        "",
        deep=True,
        seconds=0.5,
    ),
    "ros1-lost-wake-up": Plant(
        (
            _ros1("""
            class Robot:
                def __init__(self):
                    self.ready, self.changed = False, threading.Condition()
                    rospy.Timer(rospy.Duration(0.1), self.prepare, oneshot=True)
                    rospy.Timer(rospy.Duration(0.1), self.work, oneshot=True)
                def prepare(self, event):
                    with self.changed:  #+
                        self.ready = True  #+
                    self.ready = True  #-
                    with self.changed:
                        self.changed.notify()
                def work(self, event):
                    if not self.ready:  #-
                        with self.changed:  #-
                            self.changed.wait()  #-
                    with self.changed:  #+
                        while not self.ready:  #+
                            self.changed.wait()  #+
                    print("worked")
            """)
            + _SPIN_1,
        ),
        "worked",
        deep=True,
        seconds=0.5,
    ),
    # --- ROS 2 ---
    "ros2-lost-update": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.count = 0
                    group = ReentrantCallbackGroup()  #-
                    group = MutuallyExclusiveCallbackGroup()  #+
                    for _ in range(2):
                        self.create_timer(0.1, self.tick, callback_group=group)
                def tick(self):
                    self.count += self.read()
                    print("count", self.count)
                def read(self):
                    return 1
            """)
            + _MANY_2,
        ),
        "count 10\n",
        deep=True,
        seconds=0.5,
    ),
    "ros2-lock-order": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.map, self.pose = threading.Lock(), threading.Lock()
                    self.create_timer(0.1, self.plan, callback_group=ReentrantCallbackGroup())
                    self.create_timer(0.1, self.localise, callback_group=ReentrantCallbackGroup())
                def plan(self):
                    with self.map:
                        print("plans")
                        with self.pose:
                            pass
                def localise(self):
                    with self.pose:  #-
                    with self.map:  #+
                        print("localised")
                        with self.map:  #-
                        with self.pose:  #+
                            pass
            """)
            + _MANY_2,
        ),
        "(localised.*){10}",
        deep=True,
    ),
    "ros2-stop-or-step": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.steps, self.runs, self.until = 0, True, 1000
                    self.create_timer(0.1, self.step)
                    self.create_subscription(UInt32, "/stop", self.stop, 1)
                def step(self):
                    if self.runs:  #-
                    if self.steps < self.until:  #+
                        self.steps += 1
                        print("step", self.steps)
                def stop(self, message):
                    self.runs = False
                    self.until = message.data
            """)
            + _SPIN_2,
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("judge")
                    self.publisher = self.create_publisher(UInt32, "/stop", 1)
                    self.create_timer(2.0, lambda: self.publisher.publish(UInt32(data=20)))
            """)
            + _SPIN_2,
        ),
        r"step 20\n(?!.*step)",
        deep=False,
        seconds=2.5,
    ),
    "ros2-late-discovery": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("listener")
                    qos = QoSProfile(depth=1)  #-
                    qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  #+
                    self.create_subscription(Float64, "/goal", lambda message: print("goal", message.data), qos)
            """)
            + _SPIN_2,
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("talker")
                    qos = QoSProfile(depth=1)  #-
                    qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)  #+
                    self.publisher = self.create_publisher(Float64, "/goal", qos)
                    self.timer = self.create_timer(0.5, self.publish)
                def publish(self):
                    self.publisher.publish(Float64(data=1.0))
                    self.timer.cancel()
            """)
            + _SPIN_2,
        ),
        r"goal 1\.0",
        deep=False,
        seconds=2.0,
    ),
    "ros2-two-topics": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.goal, self.asked = None, False
                    self.create_subscription(Float64, "/goal", self.set_goal, 1)
                    self.create_subscription(UInt32, "/go", self.go, 1)
                def set_goal(self, message):
                    self.goal = message.data
                    if self.asked:  #+
                        print("went to", self.goal)  #+
                def go(self, message):
                    self.asked = True
                    if self.goal is not None:  #+
                        print("went to", self.goal)  #+
                    print("went to", self.goal + 0.0)  #-
            """)
            + _SPIN_2,
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("commander")
                    self.goal = self.create_publisher(Float64, "/goal", 1)
                    self.go = self.create_publisher(UInt32, "/go", 1)
                    self.timer = self.create_timer(2.0, self.command)
                def command(self):
                    self.goal.publish(Float64(data=7.0))
                    self.go.publish(UInt32(data=1))
            """)
            + _SPIN_2,
        ),
        r"went to 7\.0",
        deep=False,
        seconds=2.5,
    ),
    "ros2-check-then-act": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.free, self.docked = True, 0
                    one = MutuallyExclusiveCallbackGroup()
                    other = MutuallyExclusiveCallbackGroup()  #-
                    other = one  #+
                    self.create_timer(0.1, self.dock, callback_group=one)
                    self.create_timer(0.1, self.dock, callback_group=other)
                    self.create_timer(0.5, lambda: print("docked", self.docked))
                def dock(self):
                    if self.free:
                        self.get_logger().debug("docks")
                        self.free = False
                        self.docked += 1
            """)
            + _MANY_2,
        ),
        "docked 1\n",
        deep=True,
        seconds=0.5,
    ),
    "ros2-who-asks-first": Plant(
        (
            _ros2("""
            from std_srvs.srv import Trigger
            class Robot(Node):
                def __init__(self):
                    super().__init__("desk")
                    self.count = 0
                    for name in ("/ticket_a", "/ticket_b"):
                        self.create_service(Trigger, name, lambda request, answer, name=name: self.give(name, answer))
                def give(self, name, answer):
                    self.count += 1
                    answer.message = str(self.count)  #-
                    answer.message = "1" if name == "/ticket_a" else "2"  #+
                    return answer
            """)
            + _SPIN_2,
            *(
                _ros2(f"""
                from std_srvs.srv import Trigger
                class Robot(Node):
                    def __init__(self):
                        super().__init__("{name}")
                        self.client = self.create_client(Trigger, "/ticket_{name}")
                        self.timer = self.create_timer(2.0, self.ask)
                    def ask(self):
                        self.timer.cancel()
                        self.client.call_async(Trigger.Request()).add_done_callback(
                            lambda future: print("{name} is", future.result().message)
                        )
                """)
                + _SPIN_2
                for name in "ab"
            ),
        ),
        r"a is 1\n.*b is 2\n|b is 2\n.*a is 1\n",
        deep=False,
        seconds=2.5,
    ),
    "ros2-who-begins": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.speed = None
                    self.create_timer(0.1, self.choose, callback_group=ReentrantCallbackGroup())
                    self.create_timer(0.1, self.drive, callback_group=ReentrantCallbackGroup())
                def choose(self):
                    self.speed = 1.0
                def drive(self):
                    if self.speed is not None:  #+
                        print("speed", self.speed)  #+
                    print("speed", 1.0 * self.speed)  #-
            """)
            + _MANY_2,
        ),
        r"speed 1\.0",
        deep=False,
        seconds=0.5,
    ),
    "ros2-two-consumers": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.work, self.lock, self.go = [1], threading.Lock(), threading.Event()
                    self.create_timer(0.1, self.go.set)
                    for _ in range(2):
                        threading.Thread(target=self.consume, daemon=True).start()
                def consume(self):
                    self.go.wait()
                    with self.lock:  #+
                    if True:  #-
                        if len(self.work):
                            self.work.pop()
                    print("consumed")
            """)
            + _SPIN_2,
        ),
        "consumed\nconsumed",
        deep=True,
        seconds=0.5,
    ),
    "ros2-changed-while-iterating": Plant(
        (
            _ros2("""
            class Robot(Node):
                def __init__(self):
                    super().__init__("robot")
                    self.poses = {1: 0.0, 2: 0.0}
                    self.create_timer(0.1, self.add, callback_group=ReentrantCallbackGroup())
                    self.create_timer(0.1, self.report, callback_group=ReentrantCallbackGroup())
                def add(self):
                    self.poses[len(self.poses) + 1] = 0.0
                def report(self):
                    for name in self.poses:  #-
                    for name in list(self.poses):  #+
                        pose = self.poses[name]
                    print("well")
            """)
            + _MANY_2,
        ),
        "well",
        deep=True,
        seconds=0.5,
    ),
}
