"""Answers to the exercises on ROS 2, right and wrong, as those on ROS 1 are given in ``answers_ros1``."""

from __future__ import annotations

Answer = str | dict[str, str]

# --- predictions ------------------------------------------------------------------------------------------------------

SHORT, LONG = "after_1_0_seconds = [2.2, 2.4, 2.8]", "after_1_8_seconds = [3.0, 3.2, 3.6]"
ORDER, REPORT = "order = [1, 2, 1, 2]", "report = [9]"
ALWAYS, UNSPUN = "always_slow = [0.4, 1.0, 1.6]", "without_spin = []"


def times(found: str, *wrong: object) -> dict[str, str]:
    """A prediction replaced by another."""
    return {found: f"{found.partition(' = ')[0]} = {list(wrong)}"}


# --- nodes ------------------------------------------------------------------------------------------------------------

SAYS = '        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))\n'
CANCELS = "        self.timer.cancel()\n"
KEEPS = "self.timer = self.create_timer(1.5, self.timer_callback)"
HEARTBEAT = "        self.create_timer(1.0, self.heartbeat_callback)\n"
SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
MAIN = f"    spinner_py_node = SpinnerPyNode()\n{TRY}"

# Without a class of its own: a node, and functions around it.
PLAIN = """import sys
import rclpy
rclpy.init()
node = rclpy.create_node("n")
count = 0
def callback():
    global count
    count += 1
    node.get_logger().info("[SPINNER PY NODE] counter = %d" % count)
MADE
rclpy.spin(node)
"""

PERIOD = '        period = self.declare_parameter("period", 0.5).value\n'
REFUSES = (
    "        if not period > 0:\n"
    '            self.get_logger().error("the period has to be above 0 s, not " + str(period))\n'
    "            sys.exit(1)\n"
)
FREQUENCY = 'self.declare_parameter("frequency", 2.0).value'

CAMERA = "self.create_timer(1.0, self.camera_callback, MutuallyExclusiveCallbackGroup())"
MOTOR = "self.create_timer(0.1, self.motor_callback, MutuallyExclusiveCallbackGroup())"
ALONE = {", MutuallyExclusiveCallbackGroup())": ")"}  # neither timer has a group
EXECUTOR = "    executor = MultiThreadedExecutor()\n    executor.add_node(robot_py_node)\n"
SPINS = "        executor.spin()\n"
WORK = """    def camera_callback(self):
        self.images += 1
        self.get_logger().info("[CAMERA] image = " + str(self.images))
        time.sleep(self.takes)
        self.get_logger().info("[CAMERA] done = " + str(self.images))
"""

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

# The loop in the main part, and a thread that spins; signals are caught wherever they come out.
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

DRIVE_SPIN = "        rclpy.spin(driver_py_node)\n"
STOPS = "        motor.drive(0.0)\n"
DRIVE_END = f"    finally:\n{STOPS}        rclpy.try_shutdown()\n"
DRIVES = "        self.motor.drive(speed)\n"

ASKS_EACH_SECOND = "self.create_timer(1.0, self.timer_callback)"
MUTUAL_TIMER = "MutuallyExclusiveCallbackGroup()"
MUTUAL_IMPORT = "import MutuallyExclusiveCallbackGroup"
IN_A_GROUP = f"self.create_timer(1.0, self.timer_callback, groups.{MUTUAL_TIMER})"
REENTRANT = "self.create_timer(1.0, self.timer_callback, groups.ReentrantCallbackGroup())"
GROUPS = {"import rclpy\n": "import rclpy\nfrom rclpy import callback_groups as groups\n"}
IN_THREADS = {
    "rclpy.spin(robot_py_node)": "rclpy.spin(robot_py_node, MultiThreadedExecutor())",
    "import ExternalShutdownException\n": "import ExternalShutdownException, MultiThreadedExecutor\n",
}
DONE = """        future = self.client.call_async(Trigger.Request())
        future.add_done_callback(self.done_callback)

    def done_callback(self, future):
        self.get_logger().info(future.result().message)
"""
DONE_AT_ONCE = """        future = self.client.call_async(Trigger.Request())
        self.get_logger().info(future.result().message)
"""
CALLS = """        response = self.client.call(Trigger.Request())
        self.get_logger().info(response.message)
"""
AWAITS = CALLS.replace("self.client.call(", "await self.client.call_async(")
CALLS_IN_A_THREAD = f"""        threading.Thread(target=self.ask, daemon=True).start()

    def ask(self):
{CALLS}"""
POLLS = DONE_AT_ONCE.replace(
    "        self.get", "        while not future.done():\n            time.sleep(0.1)\n        self.get"
)
SPINS_IN_IT = DONE_AT_ONCE.replace(
    "        self.get", "        rclpy.spin_until_future_complete(self, future)\n        self.get"
)

EYES = """    def timer_callback(self):
        self.left.call(Trigger.Request())
        self.right.call(Trigger.Request())
"""
SLOW_GROUP = f",\n            callback_group={MUTUAL_TIMER})"
SLOW_SERVICE = f"""self.create_service(
            Trigger, "take_picture", self.picture_callback{SLOW_GROUP}"""
SPIN_SLOW = "        rclpy.spin(robot_py_node, MultiThreadedExecutor())\n"

LOOKS = """            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
"""
APPENDS = "            numbers.append(numbers[-1] + numbers[-2])\n"
SLEEPS_HALF = "            time.sleep(0.5)\n"
SUCCEEDS = "        goal.succeed()\n"
MAY_CANCEL = """    def may_cancel(self, goal):
        return CancelResponse.ACCEPT

"""

# --- start ------------------------------------------------------------------------------------------------------------

MAKES = "self.create_timer(0.1, self.timer_callback)"
NOT_HZ = "the period is 1 / frequency"
FAST = "self.create_timer(0.1, self.fast_callback)"
SLOW = "self.create_timer(0.5, self.slow_callback)"
OWN_COUNTER = "Give each timer a counter of its own"
AS_MANY = "as many timers as it likes"

FIRST, PASSES = "timer = [0.4, 0.8, 1.2]", "loop = [0.0, 0.4, 0.8]"
ONE_CALL = "spin_once = [0.4]"

# --- publish ----------------------------------------------------------------------------------------------------------

MAKES_PUBLISHER = '        self.publisher = self.create_publisher(UInt32, "counter", 10)\n'
PUBLISHES = "        self.publisher.publish(UInt32(data=self.counter))\n"
IN_INIT = "in `__init__`, and let the callback publish"
BOTH, KEEPS_ONE = "both_plain = [4, 5, 6]", "both_keep = [3, 4, 5]"
ONE_SIDE, OTHER_SIDE = "only_publisher = [4, 5, 6]", "only_subscription = []"
HEARS = "self.position_callback, qos_profile_sensor_data)"
RELIABLE = "The subscription asks for reliable messages"
TAKES_ONE = "self.position_callback, 1)"
QUEUE = "how many messages may wait there"
STAYS = "The sensor is to stay as it is"
IMPORTS_QOS = "from rclpy.qos import qos_profile_sensor_data"
BEST = "QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)"
IMPORTS_BEST = {IMPORTS_QOS: f"{IMPORTS_QOS}, QoSProfile, ReliabilityPolicy"}

# --- right ------------------------------------------------------------------------------------------------------------

RIGHT: dict[str, list[Answer]] = {
    "make-it-10-hz": [
        {SAYS: '        print(f"[SPINNER PY NODE]  counter={self.counter}")\n'},
        {MAKES: "self.create_timer(1 / 10, self.timer_callback)"},
        {MAKES: "self.create_timer(timer_period_sec=0.1, callback=self.timer_callback)"},
        {MAKES: "self.timer = self.create_timer(0.1, lambda: self.timer_callback())"},
        {TRY: "    rclpy.spin(spinner_py_node)\n"},
        {TRY: "    while rclpy.ok():\n        rclpy.spin_once(spinner_py_node)\n"},
        PLAIN.replace("MADE", "node.create_timer(0.1, callback)"),
    ],
    "first-call": [
        {FIRST: "timer = (0.4, 0.8, 1.2)"},
        {FIRST: "timer = [0.4 * n for n in range(1, 4)]"},
        {PASSES: "loop = [0, .4, .8]"},
        {PASSES: "loop = list((0.0, 0.4, 0.8))"},
        {PASSES: "loop = [0.0, 0.4, 0.8]\nprint(loop)"},
    ],
    "two-timers": [
        {SLOW: "self.create_timer(1 / 2, self.slow_callback)"},
        {FAST: f"self.fast = {FAST}", SLOW: f"self.slow = {SLOW}"},
        {SLOW: "self.create_timer(0.5, lambda: self.slow_callback())"},
        {TRY: "    rclpy.spin(spinner_py_node)\n"},
        {
            "import rclpy\n": "from itertools import count\n\nimport rclpy\n",
            "        self.fast_counter = 0\n": "        self.numbers = count(1)\n",
            "        self.fast_counter += 1\n": "",
            "str(self.fast_counter)": "str(next(self.numbers))",
        },
    ],
    "who-calls": [
        {UNSPUN: "without_spin = ()"},
        {UNSPUN: "without_spin = list()\nprint(without_spin)"},
        {ONE_CALL: "spin_once = (0.4,)"},
        {ONE_CALL: "spin_once = [2 / 5]"},
        {ONE_CALL: "spin_once = [.4]", UNSPUN: "without_spin = []  # nobody spins"},
    ],
    "publish-a-counter": [
        {
            PUBLISHES: "        message = UInt32()\n        message.data = self.counter\n"
            "        self.publisher.publish(message)\n"
        },
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"/counter"')},
        {MAKES_PUBLISHER: MAKES_PUBLISHER.replace(", 10)", ", 1)")},
        {"self.create_timer(0.2,": "self.create_timer(1 / 5,"},
        {TRY.replace("spinner", "robot"): "    rclpy.spin(robot_py_node)\n"},
    ],
    "late-listener": [
        {BOTH: "both_plain = (4, 5, 6)"},
        {KEEPS_ONE: "both_keep = list(range(3, 6))"},
        {ONE_SIDE: "only_publisher = [4.0, 5.0, 6.0]"},
        {OTHER_SIDE: "only_subscription = ()"},
        {OTHER_SIDE: "only_subscription = list()\nprint(only_subscription)"},
    ],
    "match-the-qos": [
        {HEARS: "self.position_callback, qos_profile_sensor_data, raw=False)"},
        {HEARS: f"self.position_callback, {BEST})", **IMPORTS_BEST},
        {HEARS: f"self.position_callback, qos_profile=({BEST}))", **IMPORTS_BEST},
        {
            HEARS: "self.position_callback, rclpy.qos.qos_profile_sensor_data)",
            IMPORTS_QOS: f"import rclpy.qos\n{IMPORTS_QOS}",
        },
        {TRY.replace("spinner", "robot"): "    rclpy.spin(robot_py_node)\n"},
    ],
    "only-the-newest": [
        {TAKES_ONE: "self.position_callback, qos_profile=1)"},
        {
            TAKES_ONE: "self.position_callback, QoSProfile(depth=1))",
            "from std_msgs": "from rclpy.qos import QoSProfile\nfrom std_msgs",
        },
        {
            TAKES_ONE: "self.position_callback, 1, callback_group=MutuallyExclusiveCallbackGroup())",
            "0.1, self.sensor_callback, MutuallyExclusiveCallbackGroup()": "0.1, self.sensor_callback",
        },
        {"time.sleep(0.33)": "time.sleep(0.35)"},
        {
            TAKES_ONE: "self.store, 10)\n        self.newest = None\n"
            "        self.create_timer(0.01, self.step, MutuallyExclusiveCallbackGroup())",
            "    def position_callback(self, message):\n": "    def store(self, message):\n"
            "        self.newest = message.data\n\n    def step(self):\n        if self.newest is None:\n"
            "            return\n",
            "str(message.data)": "str(self.newest)",
        },
    ],
    "slow-timer": [
        {SHORT: "after_1_0_seconds = (2.2, 2.4, 2.8)"},
        {LONG: "after_1_8_seconds = [3, 3.2, 3.6]"},
        {ALWAYS: "always_slow = [0.4 + 0.6 * n for n in range(3)]"},
        {ALWAYS: "always_slow = (0.4, 1, 1.6)"},
        {SHORT: SHORT + "\nprint(after_1_0_seconds)"},
    ],
    "call-back-once": [
        {CANCELS + "        self.counter += 1\n" + SAYS: "        self.counter += 1\n" + SAYS + CANCELS},
        {CANCELS: "        self.destroy_timer(self.timer)\n"},
        {CANCELS: "        self.timer.destroy()\n"},
        # The heartbeat cancels it.
        {
            CANCELS: "",
            "        self.beats += 1\n": "        self.beats += 1\n        if self.beats == 2: self.timer.cancel()\n",
        },
        {KEEPS: "self.timer = self.create_timer(1.5, lambda: self.timer_callback())"},
        {KEEPS: "self.timer = self.create_timer(timer_period_sec=1.5, callback=self.timer_callback)"},
        {TRY: "    rclpy.spin(spinner_py_node)\n"},
        {TRY: "    while rclpy.ok():\n        rclpy.spin_once(spinner_py_node)\n"},
        {
            "import ExternalShutdownException": "import ExternalShutdownException, SingleThreadedExecutor",
            SPIN: "        executor = SingleThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
            "        executor.spin()\n",
        },
        {
            "import ExternalShutdownException": "import ExternalShutdownException, MultiThreadedExecutor",
            SPIN: "        executor = MultiThreadedExecutor()\n        executor.add_node(spinner_py_node)\n"
            "        executor.spin()\n",
        },
        {TRY: "    try:\n        rclpy.spin(spinner_py_node)\n    finally:\n        rclpy.shutdown()\n"},
    ],
    "period-parameter": [
        {
            PERIOD: '        self.declare_parameter("period", 0.5)\n'
            '        period = self.get_parameter("period").value\n'
        },
        {
            PERIOD: '        self.declare_parameter("period", 0.5)\n'
            '        period = self.get_parameter("period").get_parameter_value().double_value\n'
        },
        {REFUSES: '        if period <= 0:\n            raise SystemExit("period must be above 0")\n'},
        # It looks in main, and returns a status.
        {
            REFUSES: '        if period <= 0:\n            raise ValueError("a period of " + str(period) + " s")\n',
            "    spinner_py_node = SpinnerPyNode()\n": "    try:\n        spinner_py_node = SpinnerPyNode()\n"
            "    except ValueError as error:\n        print(error, file=sys.stderr)\n        return 2\n",
            "'__main__':\n    main()": "'__main__':\n    sys.exit(main())",
        },
        # rclpy looks itself.
        {
            PERIOD: "        from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor\n"
            "        allowed = FloatingPointRange(from_value=0.001, to_value=3600.0)\n"
            "        try:\n"
            '            period = self.declare_parameter("period", 0.5, '
            "ParameterDescriptor(floating_point_range=[allowed])).value\n"
            "        except rclpy.exceptions.InvalidParameterValueException as error:\n"
            "            self.get_logger().fatal(str(error))\n"
            "            sys.exit(1)\n",
            REFUSES: "",
            "import rclpy\n": "import rclpy\nimport rclpy.exceptions\n",
        },
        PLAIN.replace(
            "MADE",
            'period = node.declare_parameter("period", 0.5).value\nif period <= 0: sys.exit("bad period")\n'
            "node.create_timer(period, callback)",
        ),
        {REFUSES: REFUSES.replace("sys.exit(1)", "rclpy.shutdown()\n            sys.exit(3)")},
    ],
    "move-to-ros-2": [
        PLAIN.replace("MADE", f"node.create_timer(1 / {FREQUENCY.replace('self', 'node')}, callback)"),
        {FREQUENCY: 'float(self.declare_parameter("frequency", 2.0).value)'},
        {FREQUENCY: 'self.declare_parameter("frequency", value=2.0).get_parameter_value().double_value'},
        {SPIN: "        while rclpy.ok():\n            rclpy.spin_once(spinner_py_node, timeout_sec=1.0)\n"},
        {TRY: "    rclpy.spin(spinner_py_node)\n    spinner_py_node.destroy_node()\n    rclpy.shutdown()\n"},
        {
            "class SpinnerPyNode(Node):\n    def __init__(self):\n        super()": "class SpinnerPyNode(Node):\n"
            "    def __init__(self, **kwargs):\n        super()",
            "    rclpy.init()\n": "    rclpy.init(args=None)\n",
        },
    ],
    "starving-neighbour": [
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
    ],
    "find-the-order": [
        {ORDER: "order = (1, 2, 1, 2)"},
        {ORDER: "order = [1, 2] * 2"},
        {REPORT: "report = (9,)"},
        {REPORT: "report = [10 - 1]"},
        {ORDER: "order = list((1, 2)) + [1, 2]", REPORT: "report = [9.0]"},
    ],
    "wake-a-rate": [
        {SPIN_CAUGHT: f"    try:\n{SPIN}{CAUGHT}    finally:\n        rclpy.try_shutdown()\n"},
        {
            THREAD: THREAD + "    executor = rclpy.executors.SingleThreadedExecutor()\n"
            "    executor.add_node(spinner_py_node)\n",
            SPIN: "        executor.spin()\n",
            "import rclpy\n": "import rclpy\nimport rclpy.executors\n",
        },
        # A loop that sleeps on the clock needs nobody who spins.
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
        # The loop itself lets the timer of its Rate be called.
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
    ],
    "end-without-a-traceback": [
        {
            CAUGHT: "    except (ExternalShutdownException, KeyboardInterrupt):\n        pass\n",
        },
        {
            CAUGHT: "    except KeyboardInterrupt:\n"
            "        pass\n    except ExternalShutdownException:\n        pass\n",
        },
        {
            "import rclpy\n": "import contextlib\n\nimport rclpy\n",
            f"    try:\n{DRIVE_SPIN}{CAUGHT}{DRIVE_END}": "    try:\n"
            "        with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):\n"
            "            rclpy.spin(driver_py_node)\n    finally:\n        motor.drive(0)\n",
        },
        {DRIVE_END: "    finally:\n        motor.drive(0.0)\n        driver_py_node.destroy_node()\n"},
        {DRIVE_END: DRIVE_END.replace("rclpy.try_shutdown()", "if rclpy.ok():\n            rclpy.shutdown()")},
        {
            DRIVE_SPIN: "        executor = rclpy.executors.SingleThreadedExecutor()\n"
            "        executor.add_node(driver_py_node)\n        executor.spin()\n",
            "import rclpy\n": "import rclpy\nimport rclpy.executors\n",
        },
        {
            "import rclpy\n": "import atexit\n\nimport rclpy\n",
            "    motor = Motor()\n": "    motor = Motor()\n    atexit.register(motor.drive, 0.0)\n",
            STOPS: "",
        },
        {DRIVE_SPIN: "        while rclpy.ok():\n            rclpy.spin_once(driver_py_node)\n"},
    ],
    "ask-without-hanging": [
        {
            ".add_done_callback(self.done_callback)": ".add_done_callback(\n"
            "            lambda done: self.get_logger().info(done.result().message))"
        },
        # It waits without keeping the thread, or with another one.
        {DONE: AWAITS, "def timer_callback": "async def timer_callback", ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS},
        {DONE: CALLS, ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS, **IN_THREADS},
        {DONE: CALLS, ASKS_EACH_SECOND: REENTRANT, **GROUPS, **IN_THREADS},
        {DONE: CALLS_IN_A_THREAD, "import rclpy\n": "import threading\nimport rclpy\n"},
    ],
    "let-a-callback-wait": [
        {"MultiThreadedExecutor()": "MultiThreadedExecutor(2)"},
        {MUTUAL_TIMER: "ReentrantCallbackGroup()", MUTUAL_IMPORT: "import ReentrantCallbackGroup"},
        # Each end in a group of its own.
        {
            f", {MUTUAL_TIMER}": "",
            "self.eye_callback)": f"self.eye_callback, callback_group={MUTUAL_TIMER})",
            '"left_eye")': f'"left_eye", callback_group={MUTUAL_TIMER})',
            '"right_eye")': f'"right_eye", callback_group={MUTUAL_TIMER})',
        },
        # Without a second thread.
        {
            "def timer_callback": "async def timer_callback",
            "self.left.call(": "await self.left.call_async(",
            "self.right.call(": "await self.right.call_async(",
            ", MultiThreadedExecutor())": ")",
        },
        {
            EYES: """    def timer_callback(self):
        self.left.call_async(Trigger.Request()).add_done_callback(self.has_left)

    def has_left(self, future):
        self.right.call_async(Trigger.Request()).add_done_callback(self.has_both)

    def has_both(self, future):
""",
            f", {MUTUAL_TIMER}": "",
            ", MultiThreadedExecutor())": ")",
        },
    ],
    "slow-service": [
        {"MultiThreadedExecutor()": "MultiThreadedExecutor(2)"},
        {SLOW_GROUP: ")", "self.motor_callback)": f"self.motor_callback, {MUTUAL_TIMER})"},
        {
            SLOW_GROUP: ")",
            "self.motor_callback)": "self.motor_callback, ReentrantCallbackGroup())",
            MUTUAL_IMPORT: "import ReentrantCallbackGroup",
        },
        {
            SPIN_SLOW: "        executor = MultiThreadedExecutor(num_threads=3)\n"
            "        executor.add_node(robot_py_node)\n        executor.spin()\n"
        },
        # The camera is a node with an executor and a thread of its own.
        {
            SLOW_SERVICE: 'self.camera = rclpy.create_node("camera")\n'
            '        self.camera.create_service(Trigger, "take_picture", self.picture_callback)',
            SPIN_SLOW: "        executor = SingleThreadedExecutor()\n"
            "        executor.add_node(robot_py_node.camera)\n"
            "        threading.Thread(target=executor.spin, daemon=True).start()\n"
            "        rclpy.spin(robot_py_node)\n",
            "import time\n": "import threading\nimport time\n",
            "MultiThreadedExecutor\n": "SingleThreadedExecutor\n",
        },
    ],
    "cancel-a-goal": [
        {"MultiThreadedExecutor())": "MultiThreadedExecutor(2))"},
        {"cancel_callback=self.may_cancel": "cancel_callback=lambda goal: CancelResponse.ACCEPT"},
        # It looks after each number.
        {LOOKS + APPENDS: APPENDS, SLEEPS_HALF: SLEEPS_HALF + LOOKS},
        # It leaves the loop.
        {
            LOOKS: "            if goal.is_cancel_requested:\n                break\n",
            SUCCEEDS: "        goal.canceled() if goal.is_cancel_requested else goal.succeed()\n",
        },
        {
            "while len(numbers) < goal.request.order:\n": "while len(numbers) < goal.request.order "
            "and not goal.is_cancel_requested:\n",
            LOOKS: "",
            SUCCEEDS: "        if goal.is_cancel_requested:\n            goal.canceled()\n"
            "        else:\n            goal.succeed()\n",
        },
        {
            MAY_CANCEL: "",
            "            cancel_callback=self.may_cancel)\n": "            )\n"
            "        self.server.register_cancel_callback(lambda goal: CancelResponse.ACCEPT)\n",
        },
    ],
}

# --- wrong ------------------------------------------------------------------------------------------------------------

EACH_FIFTH = {
    f"        {SLOW}\n": "",
    "str(self.fast_counter))\n": "str(self.fast_counter))\n        if self.fast_counter % 5 == 0:\n"
    "            self.slow_callback()\n",
}
TWO_NODES = """import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
class Counts(Node):
    def __init__(self, tag, period):
        super().__init__(tag.lower())
        self.tag, self.counter = tag, 0
        self.create_timer(period, self.count)
    def count(self):
        self.counter += 1
        self.get_logger().info(f"[{self.tag}] counter = {self.counter}")
rclpy.init()
executor = SingleThreadedExecutor()
nodes = [Counts("FAST", 0.1), Counts("SLOW", 0.5)]
for node in nodes:
    executor.add_node(node)
executor.spin()
"""
SLOW_THREAD = {
    f"        {SLOW}\n": "        threading.Thread(target=self.slow_loop, daemon=True).start()\n",
    "    def slow_callback(self):\n": "    def slow_loop(self):\n        while True:\n            time.sleep(0.5)\n"
    "            self.slow_callback()\n\n    def slow_callback(self):\n",
    "import rclpy\n": "import threading\nimport time\n\nimport rclpy\n",
}
IN_EACH_CALL = {  # a publisher is made for each message
    MAKES_PUBLISHER: "",
    PUBLISHES: f"{MAKES_PUBLISHER}{PUBLISHES}",
}
MADE_ONCE = "Make it once, before the timer"
CALLED_ITSELF = "        self.position_callback(UInt32(data=self.position))\n"
MAKES_SENSOR = 'self.create_publisher(UInt32, "position", qos_profile_sensor_data)'

FOR_ROS_1 = "import rospy\nrospy.init_node('n')\nrospy.spin()\n"

WRONG: dict[str, list[tuple[Answer, str, str]]] = {
    "make-it-10-hz": [
        ({MAKES: f"{MAKES}\n        {MAKES}"}, "counter 2 came at 0.1 s, not at 0.2 s", "two at a time"),
        ({MAKES: "self.create_timer(0,1, self.timer_callback)"}, "no attribute 'add_entity'", "`0,1` is two numbers"),
        ({MAKES: "self.createTimer(0.1, self.timer_callback)"}, "attribute 'createTimer'", "There is a `create_timer`"),
        ({MAKES: "self.create_timer(0.1, timer_callback)"}, "name 'timer_callback'", "it is `self.timer_callback`"),
        ({"import rclpy\n": "import rclpy\nimport no_module\n"}, "No module named", "Is the module spelt right?"),
        (
            {"(self):\n        super()": "(self):\n        self.t = None  # super()"},
            "has no attribute",
            "begins its __init__",
        ),
        ({MAKES: "self.create_timer(10, self.timer_callback)"}, "no counter was printed", NOT_HZ),
        ({MAKES: "self.create_timer(10.0, self.timer_callback)"}, "no counter was printed", NOT_HZ),
        ({"(0.1,": "(0.5,"}, "counter 1 came at 0.5 s, not at 0.1 s", NOT_HZ),
        ({"(0.1,": "(0.01,"}, "counter 1 came at 0.01 s, not at 0.1 s", NOT_HZ),
        (
            {"(0.1,": "(1 // 10,"},
            "The node has a timer whose period is 0 s: it is called without a pause",
            "In Python `1 // 10` is 0, and `1 / 10` is 0.1.",
        ),
        ({"(0.1,": "(-0.1,"}, "timer period must be non-negative", "cannot be negative"),
        ({"+= 1": "+= 10"}, "where counter 1 was due, counter 10 came", "The counter goes up by 10 each time:"),
        ({TRY: ""}, "no counter was printed", "The node ended by itself"),
        ({"self.timer_callback)": "self.timer_callback())"}, "'NoneType' object is not callable", "without calling it"),
        (
            {"(self):\n        self.counter += 1": "(self, event):\n        self.counter += 1"},
            "TypeError",
            "no argument",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "first-call": [
        (times(FIRST, 0.0, 0.4, 0.8), "The timer: not 0 s, 0.4 s, 0.8 s", "waits for one period before its first"),
        (times(FIRST, 2.5, 5.0, 7.5), "The timer: not 2.5 s", "takes the number for a frequency"),
        (times(FIRST, 0.0, 2.5, 5.0), "The timer: not 0 s, 2.5 s", "takes the number for a frequency"),
        (times(FIRST, 0.4, 0.8, 1.3), "the third of these times is not 1.3 s", "And before the first one?"),
        (times(FIRST, 0.4, 0.8), "3 times are asked for, not 2", "And before the first one?"),
        (times(PASSES, 0.4, 0.8, 1.2), "The loop: not 0.4 s", "makes its first pass immediately"),
        (times(PASSES, 0.0, 0.5, 1.0), "the second of these times is not 0.5 s", "Follow it line by line"),
        ({PASSES: "loop = 0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
        ({PASSES: "loop = ..."}, "The loop: there is no prediction yet", "Give `loop`"),
    ],
    "two-timers": [
        (EACH_FIFTH, "one timer prints both `[FAST]` and `[SLOW]`", "a timer of its own for each"),
        (TWO_NODES, "the timers are of two nodes, `/fast` and `/slow`", "One node can have both"),
        (SLOW_THREAD, "counter 1 of `[SLOW]` was not printed by the callback of a timer", "a timer of its own"),
        (
            {"slow_counter": "fast_counter"},
            "`[SLOW]`: where counter 1 was due, counter 6 came",
            "Something else counts in the same variable:",
        ),
        ({"(0.5,": "(2.0,"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s", AS_MANY),
        (
            {"(0.5,": "(5,"},
            "`[SLOW]`: no counter was printed",
            "A timer of the node has a period of 5 s, so that its first call is due",
        ),
        ({"(0.1,": "(0.5,"}, "`[FAST]`: counter 1 came at 0.5 s", AS_MANY),
        (
            {"[SLOW]": "[slow]"},
            "`[SLOW]`: no counter was printed",
            "The lines are to read `[SLOW] counter = 1` and so on.",
        ),
        ({"self.slow_callback)": "self.fast_callback)"}, "`[SLOW]`: no counter was printed", "callback and counter"),
        ({"        self.slow_counter = 0\n": ""}, "has no attribute 'slow_counter'", "Python names"),
        ({f"        {SLOW}\n": ""}, "`[SLOW]`: no counter was printed", AS_MANY),
        (
            {
                "str(self.slow_counter))": "str(self.slow_counter))\n        time.sleep(0.6)",
                "import rclpy\n": "import time\n\nimport rclpy\n",
            },
            "`[FAST]`: counter 6 came at",
            AS_MANY,
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "who-calls": [
        (times(UNSPUN, 0.4, 0.8, 1.2), "Without spin: not 0.4 s", "has no thread of its own"),
        (times(UNSPUN, 0.4, 0.8, 1.2, 1.6, 2.0), "Without spin: not 0.4 s", "called by the thread that spins"),
        (times(UNSPUN, 0.0), "Without spin: not 0 s", "called by the thread that spins"),
        (times(UNSPUN, 0.1, 0.2), "Without spin: not 0.1 s", "has no thread of its own"),
        (times(ONE_CALL), "With one `spin_once`: not nothing at all", "waits until something is due"),
        (times(ONE_CALL, 0.0), "With one `spin_once`: not 0 s", "Nothing is due at the start"),
        (times(ONE_CALL, 0.4, 0.8, 1.2, 1.6, 2.0), "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
        (times(ONE_CALL, 0.4, 0.8, 1.2), "With one `spin_once`: not 0.4 s, 0.8 s", "starts nothing"),
        (times(ONE_CALL, 0.5), "With one `spin_once`: not 0.5 s", "Then it calls it"),
        ({UNSPUN: "without_spin = None"}, "Without spin: there is no prediction yet", "Give `without_spin`"),
        ({ONE_CALL: "spin_once = 0.4"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
    ],
    "publish-a-counter": [
        (
            {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('UInt32, "counter"', '"counter", UInt32')},
            "TypeError",
            "the type, the",
        ),
        ({PUBLISHES: PUBLISHES.replace("UInt32(data=self.counter)", "UInt32")}, "TypeError", "make one, with `()`"),
        ({"data=self.counter": "self.counter"}, "takes 1 positional argument", "given by their names"),
        ({"data=self.counter": "data=str(self.counter)"}, "must be of type 'int'", "values of its own type"),
        ({PUBLISHES: PUBLISHES.replace(".publish(", "(")}, "not callable", "Call what it has, such as `publish`"),
        (IN_EACH_CALL, "the node made 10 publishers of `/counter`, where one would do", MADE_ONCE),
        (
            {
                MAKES_PUBLISHER: "        self.publisher = None\n",
                PUBLISHES: "        if self.publisher is None:\n    " + MAKES_PUBLISHER + PUBLISHES,
            },
            "the publisher was made at 0.2 s, when its first message was already due",
            MADE_ONCE,
        ),
        (
            {
                MAKES_PUBLISHER: "",
                PUBLISHES: f"{MAKES_PUBLISHER}{PUBLISHES}        self.destroy_publisher(self.publisher)\n",
            },
            "the node made 10 publishers",
            MADE_ONCE,
        ),
        (
            {
                "        self.create_subscription(": "        pass  # ",
                PUBLISHES: f"{PUBLISHES}        self.counter_callback(UInt32(data=self.counter))\n",
            },
            "The listener: its lines were printed in a call of a timer",
            "A topic carries the message",
        ),
        (
            {PUBLISHES: ""},
            "on `/counter`: the node published nothing",
            "There is a publisher, but nothing publishes with it.",
        ),
        ({MAKES_PUBLISHER: ""}, "has no attribute 'publisher'", "with its `self.`"),
        (
            {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"count"')},
            "it was published on `/count`",
            "The topic of a publisher is that of the listener, letter by letter:",
        ),
        (
            {MAKES_PUBLISHER: MAKES_PUBLISHER.replace('"counter"', '"~/counter"')},
            "it was published on `/robot_py_node/counter`",
            "The topic of a publisher is that of the listener, letter by letter:",
        ),
        ({"(0.2,": "(5,"}, "nothing was published on `/counter`", "Five times a second is once in 1 / 5 s."),
        (
            {"(0.2,": "(0.5,"},
            "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s",
            "Five times a second is once in 1 / 5 s.",
        ),
        ({"UInt32(data=self.counter)": "self.counter"}, "TypeError", "A number is not yet a message:"),
        (
            {"UInt32(data=self.counter)": "UInt32()"},
            "on `/counter`: each message holds 0, not a counter.",
            "A new message holds 0.",
        ),
        (
            {"        self.counter += 1\n" + PUBLISHES: PUBLISHES + "        self.counter += 1\n"},
            "where counter 1 was due, counter 0 came",
            "The first counter is 1:",
        ),
        (
            {PUBLISHES: PUBLISHES * 2},
            "On `/counter`: where counter 2 was due, counter 1 came",
            "A counter comes more than once:",
        ),
        (
            {MAKES_PUBLISHER: MAKES_PUBLISHER.replace(", 10)", ")")},
            "missing 1 required positional",
            '`self.create_publisher(UInt32, "topic", 10)`:',
        ),
        (
            {"        self.create_subscription": "        pass  # "},
            "The listener: no counter",
            "Nothing subscribes to `/counter` any more.",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "late-listener": [
        (times(BOTH, 1, 2, 3), "With `10` on both sides: not 1, 2, 3", "the message is not kept"),
        (times(BOTH, 3, 4, 5), "With `10` on both sides: not 3, 4, 5", "the message is not kept"),
        (times(BOTH, 4, 5, 7), "the third of these counters is not 7", "the message is not kept"),
        (times(KEEPS_ONE, 4, 5, 6), "not 4, 5, 6", "keeps its last messages"),
        (times(KEEPS_ONE, 1, 2, 3), "not 1, 2, 3", "Its depth is 1"),
        (times(KEEPS_ONE, 1, 4, 5), "not 1, 4, 5", "not the first"),
        (times(ONE_SIDE, 3, 4, 5), "not 3, 4, 5", "only if it asks for that"),
        (times(ONE_SIDE), "not nothing at all", "that is enough to connect"),
        (times(OTHER_SIDE, 4, 5, 6), "not 4, 5, 6", "offers less than it asks for"),
        (times(OTHER_SIDE, 3, 4, 5), "not 3, 4, 5", "offers less than it asks for"),
        (times(OTHER_SIDE, 9), "not 9", "offers less than it asks for"),
        ({OTHER_SIDE: ""}, "there is no prediction yet", "Give `only_subscription`"),
    ],
    "match-the-qos": [
        (
            {
                HEARS: "self.position_callback, 10)",
                "(UInt32(data=self.position))\n": f"(UInt32(data=self.position))\n{CALLED_ITSELF}",
            },
            "a subscription with reliable, volatile, depth 10 does not match",
            RELIABLE,
        ),
        (
            {MAKES_SENSOR: f'self.create_publisher(UInt32, "position", {BEST})', **IMPORTS_BEST},
            "the sensor: its publisher now has best_effort, volatile, depth 10, where it had",
            STAYS,
        ),
        (
            {MAKES_SENSOR: MAKES_SENSOR.replace("qos_profile_sensor_data", "10"), HEARS: "self.position_callback, 10)"},
            "the sensor: its publisher now has reliable, volatile, depth 10",
            STAYS,
        ),
        (
            {
                HEARS: "lambda message: None, qos_profile_sensor_data)",
                "(UInt32(data=self.position))\n": f"(UInt32(data=self.position))\n{CALLED_ITSELF}",
            },
            "The controller: its lines were printed in a call of a timer",
            "A topic carries the message",
        ),
        (
            {HEARS: f'{HEARS}\n        self.create_subscription(UInt32, "position", self.position_callback, 10)'},
            "a subscription with reliable, volatile, depth 10 does not match",
            RELIABLE,
        ),
        (
            {
                HEARS: "self.position_callback, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, "
                "durability=DurabilityPolicy.TRANSIENT_LOCAL))",
                IMPORTS_QOS: f"{IMPORTS_QOS}, DurabilityPolicy, QoSProfile, ReliabilityPolicy",
            },
            "best_effort, transient_local, depth 5 does not match",
            "The sensor keeps none",
        ),
        (
            {HEARS: "self.position_callback, 10)"},
            "the controller: a subscription with reliable, volatile, depth 10 does ",
            RELIABLE,
        ),
        (
            {HEARS: "self.position_callback, 1)"},
            "the controller: a subscription with reliable, volatile, depth 1 does n",
            RELIABLE,
        ),
        (
            {
                HEARS: "self.position_callback, QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL))",
                IMPORTS_QOS: f"{IMPORTS_QOS}, DurabilityPolicy, QoSProfile",
            },
            "the controller: a subscription with reliable, transient_local, depth 5",
            RELIABLE,
        ),
        (
            {'"position", self.position_callback': '"positions", self.position_callback'},
            "the controller: nothing subscribes to `/position`: it subscribes to `/",
            "The topic of the subscription is that of the publisher, letter by lett",
        ),
        ({"0.5, self.sensor": "1.0, self.sensor"}, "The sensor: position 1 came at 1 s, not at 0.5 s", STAYS),
        (
            {"self.position_callback, qos": "self.position_callback(), qos"},
            "missing 1 required positional",
            "Pass the function on without calling it:",
        ),
        (
            {"str(message.data)": "str(message)"},
            "The controller: where position 1 was due",
            "Let the callback of the subscription print `[CONTROLLER] position = `",
        ),
        (
            {HEARS: "self.position_callback)"},
            "missing 1 required positional",
            '`self.create_subscription(UInt32, "topic", self.callback, 10)`:',
        ),
        (
            {"        self.publisher.publish": "        # self.publisher.publish"},
            "The sensor: no position was printed",
            STAYS,
        ),
    ],
    "only-the-newest": [
        (
            {TAKES_ONE: "self.position_callback, 10)", "str(message.data)": "str(self.position)"},
            "printed position 4, but the message that it got held 2",
            "in another process",
        ),
        (
            {'"position", 10)\n': '"position", 1)\n'},
            "the sensor: its publisher now has reliable, volatile, depth 1, where it had reliable, volatile, depth 10",
            STAYS,
        ),
        (
            {
                f'self.create_subscription(UInt32, "position", {TAKES_ONE}\n': "self.newest = UInt32(data=1)\n"
                "        self.create_timer(0.34, lambda: self.position_callback(self.newest), "
                "MutuallyExclusiveCallbackGroup())\n",
                "        self.publisher.publish(": "        self.newest = UInt32(data=self.position)\n"
                "        self.publisher.publish(",
            },
            "the controller: nothing subscribes to `/position`",
            "letter by letter",
        ),
        (
            {TAKES_ONE: "self.position_callback, 10)"},
            "the controller steered by position 2, which was 0.23 s old",
            QUEUE,
        ),
        ({TAKES_ONE: "self.position_callback, 2)"}, "A newer one had arrived", QUEUE),
        (
            {TAKES_ONE: "self.position_callback, 10)", '"position", 10)\n': '"position", 1)\n'},
            "A newer one had arrived",
            QUEUE,
        ),
        ({"time.sleep(0.33)": "time.sleep(0.05)"}, "less than 0.33 s after the last time", "takes 0.33 s"),
        (
            {"(0.1, self.sensor": "(0.4, self.sensor"},
            "the sensor published 25 positions",
            "The sensor is to stay as it is.",
        ),
        ({", MultiThreadedExecutor())": ")"}, "the sensor published", "The sensor is to stay as it is."),
        ({"str(message.data)": "str(message)"}, "is not a position that", "A message is not yet its number:"),
        (
            {"time.sleep(0.33)": "time.sleep(0.6)"},
            "the controller steered 17 times",
            "From one step to the next it took up to 0.6 s.",
        ),
        (
            {"        self.create_subscription": "        pass  # "},
            "the controller: nothing subscribes to `/position`.",
            "The topic of the subscription is that of the publisher, letter by lett",
        ),
        (
            {TAKES_ONE: "self.position_callback(), 1)"},
            "missing 1 required positional",
            "Pass the function on without calling it:",
        ),
    ],
    "slow-timer": [
        (times(SHORT, 2.2, 2.2, 2.4), "Blocked for 1.0 s: not 2.2 s, 2.2 s", "one of them comes immediately, and"),
        (times(SHORT, 2.2, 2.6, 3.0), "Blocked for 1.0 s: not 2.2 s, 2.6 s", "it goes back to its grid"),
        (times(SHORT, 1.6, 2.0, 2.4), "not 1.6 s", "the executor calls nothing"),
        (times(SHORT, 2.4, 2.8, 3.2), "not 2.4 s", "it comes immediately"),
        (times(LONG, 3.0, 3.4, 3.8), "Blocked for 1.8 s: not 3 s, 3.4 s", "it goes back to its grid"),
        (times(LONG, 3.0, 3.0, 3.0), "not 3 s, 3 s, 3 s", "There is no queue of calls"),
        (times(LONG, 3.2, 3.6, 4.0), "not 3.2 s", "One overdue tick still comes"),
        (times(ALWAYS, 0.4, 1.2, 2.0), "Each callback takes 0.6 s: not 0.4 s, 1.2 s", "does not wait any longer"),
        (times(ALWAYS, 0.4, 1.4, 2.4), "not 0.4 s, 1.4 s", "does not count from the end"),
        (times(ALWAYS, 0.4, 1.1, 1.8), "the second of these times is not 1.1 s", "Which tick is overdue then?"),
        ({ALWAYS: "always_slow = None"}, "Each callback takes 0.6 s: there is no prediction yet", "Give `always_slow`"),
        ({SHORT: "after_1_0_seconds = 2.2"}, "a list of times in seconds, not a value of type `float`", "Write it as"),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "call-back-once": [
        ({CANCELS: "        del self.timer\n"}, "object has no attribute 'timer'", "before this line runs"),
        ({KEEPS: KEEPS.replace(")", ", autostart=False)")}, "no counter was printed", "or never started"),
        (
            {CANCELS: "        if self.counter:\n            return\n"},
            "the callback was called 4 times in 6 s",
            "A callback that returns immediately is still called",
        ),
        (
            {CANCELS: "        rclpy.shutdown()\n"},
            "The heartbeat: counter 2, due at 2 s",
            "Stop one timer, and no more",
        ),
        ({CANCELS: "        raise SystemExit\n"}, "The heartbeat: counter 2, due", "what ends the node"),
        (
            {
                SAYS: SAYS + "        while True:\n            time.sleep(1)\n",
                "import rclpy\n": "import time\n\nimport rclpy\n",
            },
            "The heartbeat: counter 2, due",
            "keeps its callback from returning",
        ),
        ({CANCELS: "        self.executor.shutdown()\n"}, "The heartbeat: counter 2, due", "Stop one timer"),
        (
            {"self.timer = ": "timer = "},
            "AttributeError: 'SpinnerPyNode' object has no attribute 'timer'",
            "`timer` is a variable of one function.",
        ),
        (
            {KEEPS: KEEPS.replace(")", ", oneshot=True)")},
            "unexpected keyword argument 'oneshot'",
            "In ROS 2 a timer has no `oneshot`.",
        ),
        ({CANCELS: "        self.timer.shutdown()\n"}, "has no attribute 'shutdown'", "A `Timer` has no `shutdown`."),
        ({"timer_callback(self)": "timer_callback(self, event)"}, "missing 1 required positional", "no argument"),
        ({KEEPS: KEEPS.replace("timer_callback)", "timer_callback())")}, "has no attribute 'timer'", "Python names"),
        ({SPIN: "        pass\n"}, "no counter was printed", "Does its main part come to `rclpy.spin(node)`?"),
        ({"    rclpy.init()\n": ""}, "NotInitialized", "Call rclpy.init() before"),
        (
            {
                CANCELS: "        threading.Timer(1.0, self.timer.cancel).start()\n        if self.counter: return\n",
                KEEPS: "self.timer = self.create_timer(0.5, self.timer_callback)",
                "import rclpy\n": "import threading\n\nimport rclpy\n",
            },
            "counter 1 came at 0.5 s, not at 1.5 s",
            "Stop the timer itself",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "period-parameter": [
        (
            {PERIOD: '        period = float(sys.argv[-1].split(":=")[-1]) if len(sys.argv) > 1 else 0.5\n'},
            "With `period:=0.1`: the node has no parameter `period`",
            "in other ways",
        ),
        ({PERIOD: "        period = 0.5\n"}, "With `period:=0.1`: counter 1 came at 0.5 s", "is called"),
        (
            {PERIOD: '        period = self.get_parameter("period").value\n'},
            "ParameterNotDeclaredException",
            "before you read it",
        ),
        ({PERIOD: PERIOD.replace('"period"', '"delta"')}, "With `period:=0.1`: counter 1 came at 0.5 s", '"period"'),
        ({PERIOD: PERIOD.replace('"period"', '"~period"')}, "With `period:=0.1`: counter 1 came at 0.5 s", "is called"),
        (
            {PERIOD: PERIOD.replace("0.5", "1.0")},
            "Without the parameter: counter 1 came at 1 s",
            "is a parameter's value",
        ),
        (
            {"create_timer(period": "create_timer(1 / period"},
            "Without the parameter: counter 1 came at 2 s",
            "Is it what the timer is given",
        ),
        (
            {PERIOD: PERIOD.replace(".value", "")},
            "TypeError",
            "A parameter is not yet its number, which is its `.value`:",
        ),
        ({REFUSES: ""}, "With `period:=0.0`: the node ticked anyway", "calls back without a pause"),
        (
            {REFUSES: REFUSES.replace("not period > 0", "period < 0")},
            "With `period:=0.0`: the node ticked",
            "Look at the period",
        ),
        (
            {REFUSES: REFUSES.replace("not period > 0", "period == 0")},
            "With `period:=-1.0`: the node stopped in line 16:",
            "error line",
        ),
        (
            {REFUSES: "        if period <= 0:\n            raise ValueError('period')\n"},
            "ValueError: period",
            "end with `sys.exit(1)`",
        ),
        (
            {REFUSES: REFUSES.replace("sys.exit(1)", "sys.exit()")},
            "ended with status 0, as if all were well",
            "from its status",
        ),
        (
            {REFUSES: "        if period <= 0:\n            sys.exit(1)\n"},
            "no line says that the period is wrong",
            "error line",
        ),
        (
            {REFUSES: REFUSES.replace("sys.exit(1)", "return")},
            "the node kept running without ticking",
            "end with `sys.exit(1)`",
        ),
        (
            {REFUSES: REFUSES.replace("sys.exit(1)", "period = 0.5")},
            "the node ticked anyway, 2 times in 1 s",
            "Look at the",
        ),
        (
            {PERIOD: PERIOD.replace("0.5", "1")},
            "Started with `--ros-args -p period:=0.1`",
            "keeps the type with which it was declared",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "move-to-ros-2": [
        ({"self.get_logger().info(": "self.get_logger.info("}, "no attribute 'info'", "to be called first, with `()`"),
        ({"self.get_logger().info(": "rclpy.loginfo("}, "no attribute 'loginfo'", "In ROS 2 it is `self.get_logger()"),
        ({FREQUENCY: FREQUENCY.replace(".value", "")}, "and 'Parameter'", "which is its `.value`"),
        ({"SpinnerPyNode(Node):": "SpinnerPyNode:", '("spinner_py_node")': "()"}, "attribute '", "(Node)`?"),
        (FOR_ROS_1, "This node is for ROS 1: it imports `rospy`", "where a node imports `rclpy`"),
        ("import rospy, rclpy\n", "imports both", "This exercise is on ROS 2"),
        ({"timer_callback(self)": "timer_callback(self, event)"}, "missing 1 required positional", "no argument"),
        ({FREQUENCY: "2.0"}, "With `frequency:=10.0`: counter 1 came at 0.5 s", "is called"),
        ({'"frequency"': '"~frequency"'}, "With `frequency:=10.0`: counter 1 came at 0.5 s", "has no `~` in ROS 2"),
        ({FREQUENCY: 'self.get_parameter("frequency").value'}, "ParameterNotDeclared", "before you read it"),
        (
            {"create_timer(1 / frequency": "create_timer(frequency"},
            "Without the parameter: counter 1 came at 2 s",
            "is called",
        ),
        ({SPIN: "        rclpy.spin()\n"}, "missing 1 required positional argument: 'node'", "`rclpy.spin(node)`:"),
        ({SPIN: "        pass\n"}, "no counter was printed", "Does its main part come to `rclpy.spin(node)`?"),
        ({'        super().__init__("spinner_py_node")\n': ""}, "AttributeError", "begins its __init__"),
        ({"    rclpy.init()\n": ""}, "NotInitialized", "Call rclpy.init() before"),
        ({"self.get_logger().info": "self.loginfo"}, "has no attribute 'loginfo'", "Python names what"),
        (
            {FREQUENCY: FREQUENCY.replace("2.0", "2")},
            "Started with `--ros-args -p frequency:=10.0`",
            "keeps the type with which it was declared",
        ),
    ],
    "starving-neighbour": [
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
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "find-the-order": [
        (times(ORDER, 1, 1, 2, 2), "the order: not 1, 1, 2, 2", "This is the usual order"),
        (times(ORDER, 1, 2, 2, 1), "the order: not 1, 2, 2, 1", "thread 1 writes last"),
        (times(ORDER, 2, 1, 1, 2), "the order: not 2, 1, 1, 2", "Here thread 2 begins"),
        (times(ORDER, 2, 1, 2, 1), "the order: not 2, 1, 2, 1", "thread 1 writes last, over what thread 2"),
        (times(ORDER, 1, 2, 1, 2, 2), "4 numbers are asked for, not 5", "It has four lines"),
        (times(ORDER, 1, 2, 1, 1), "the fourth of these numbers is not 1", "each thread runs its first line before"),
        (times(ORDER, 2, 2, 1, 1), "the order: not 2, 2, 1, 1", "nothing is lost"),
        (times(ORDER, 1, 2), "the order: not 1, 2", "so each stands in the list twice"),
        (
            times(ORDER, 1, 1, 1, 2),
            "the order: the second of these numbers is not 1",
            "each thread runs its first line before",
        ),
        (times(REPORT, 10), "the report: not 10", "in the usual order"),
        (times(REPORT, 8), "the report: not 8", "only one of their two parts is lost"),
        (times(REPORT, 5), "the report: not 5", "not at each call"),
        (times(REPORT, 0), "the report: not 0", "stay counted"),
        (times(REPORT, 11), "the report: not 11", "written over"),
    ],
    "wake-a-rate": [
        (
            {THREAD: "", SPIN: "        spinner_py_node.loop()\n"},
            "counter 2, due at 0.5 s, did not come",
            "The first `sleep()` never returned",
        ),
        (
            {THREAD: SPINNING_THREAD, SPIN: "        spinner_py_node.loop()\n"},
            "Ctrl-C: the thread stopped with `rclpy.executors.ExternalShutdownException`",
            "Let the main part spin",
        ),
        (IN_MAIN, "SIGTERM at 3.3 s: the node did not end", "Let the main part spin"),
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
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "end-without-a-traceback": [
        (
            {"(KeyboardInterrupt, ExternalShutdownException)": "KeyboardInterrupt"},
            "SIGTERM: the node stopped in line 38:",
            "Catch both",
        ),
        (
            {"(KeyboardInterrupt, ExternalShutdownException)": "ExternalShutdownException"},
            "Ctrl-C while the node waits: the node stopped in line 38: `KeyboardInterrupt`",
            "Catch both",
        ),
        (
            {"(KeyboardInterrupt, ExternalShutdownException)": "(KeyboardInterrupt, Exception)"},
            "The sensor fails: the node ended with status 0",
            "Catch what a signal raises, and nothing else",
        ),
        (
            {"(KeyboardInterrupt, ExternalShutdownException)": "BaseException"},
            "The sensor fails: the node ended with status 0",
            "nothing else",
        ),
        ({STOPS: ""}, "nothing stops the motor", "in a `finally:`"),
        (
            {DRIVE_END: STOPS.replace("    ", "", 1) + "    rclpy.try_shutdown()\n"},
            "The sensor fails: nothing stops the motor",
            "in a `finally:`",
        ),
        ({"rclpy.try_shutdown()": "rclpy.shutdown()"}, "RCLError", "`rclpy.try_shutdown()` does not"),
        (
            {
                STOPS: "",
                "    try:\n": "    rclpy.get_default_context().on_shutdown(lambda: motor.drive(0.0))\n    try:\n",
                "rclpy.try_shutdown()": "pass",
            },
            "nothing stops the motor",
            "in a `finally:`",
        ),
        (
            {STOPS: "", CAUGHT: CAUGHT.replace("pass", "motor.drive(0.0)")},
            "The sensor fails: nothing stops the motor",
            "finally",
        ),
        (
            {
                "        speed = self.read_sensor()\n": "        try:\n            speed = self.read_sensor()\n"
                "        except RuntimeError:\n            return\n"
            },
            "the motor was not stopped before 5 s",
            "and nothing else: an error is",
        ),
        (
            {DRIVES: DRIVES + "        self.motor.drive(0.0)\n"},
            "the motor was stopped at 0.16 s",
            "has to drive the motor as before",
        ),
        (
            {CAUGHT: CAUGHT.replace("pass", "raise SystemExit(1)")},
            "ended with status 1 instead of 0",
            "Status 0 says that all is well.",
        ),
        (
            {"    try:\n": "    import signal\n    signal.signal(signal.SIGINT, signal.SIG_IGN)\n    try:\n"},
            "did not end at Ctrl-C",
            "",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "ask-without-hanging": [
        # The answer is used immediately.
        (
            {DONE: DONE_AT_ONCE},
            "the node stopped in line 24: `AttributeError: 'NoneType' object has no attribute 'message'`",
            "The result of a future is None until the answer has come",
        ),
        ({DONE: POLLS, "import rclpy\n": "import time\nimport rclpy\n"}, "was not answered", "say who waits"),
        (
            {DONE: SPINS_IN_IT},
            "was not answered",
            "say who waits",
        ),
        # A coroutine keeps the group of the service.
        (
            {DONE: AWAITS, "def timer_callback": "async def timer_callback"},
            "The request of 1 s to `/take_picture` was not answered",
            "keeps its thread and its callback group",
        ),
        ({DONE: CALLS, ASKS_EACH_SECOND: IN_A_GROUP, **GROUPS}, "was not answered", "say who waits"),
        ({DONE: CALLS, **IN_THREADS}, "did not end at Ctrl-C", "say who waits"),
        (
            {DONE: CALLS.replace("Request()", "Request(), timeout_sec=0.2")},
            "`AttributeError: 'NoneType' object",
            "until the answer has come",
        ),
        ({"(self.done_callback)": "(self.done_callback(future))"}, "stopped in line 27", "until the answer has come"),
        (
            {
                "        future = self.client.call_async(Trigger.Request())\n": "",
                "        future.add_done_callback(self.done_callback)\n": "        self.done_callback(None)\n",
                "future.result().message": '"[CAMERA] counter = 1"',
            },
            "`/take_picture` was never asked",
            "to come from the service",
        ),
        ({"1.0, self.timer": "0.5, self.timer"}, "was asked at 0.5 s, not at 1 s", "is not to change"),
        ({"        self.create_timer(0.5, self.heartbeat_callback)\n": ""}, "heartbeat: no counter", ""),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "let-a-callback-wait": [
        ({f", {MUTUAL_TIMER}": ""}, "the request of 1 s to `/left_eye` was not answered", "say who waits"),
        ({", MultiThreadedExecutor())": ")"}, "`/left_eye` was not answered", "keeps its thread"),
        ({"MultiThreadedExecutor()": "MultiThreadedExecutor(1)"}, "`/left_eye` was not answered", "say who waits"),
        # The answers come, but the clients are in the group of the callback that waits.
        (
            {
                f", {MUTUAL_TIMER}": "",
                "self.eye_callback)": f"self.eye_callback, callback_group={MUTUAL_TIMER})",
            },
            "The robot: no counter was printed",
            "say who waits",
        ),
        (
            {
                f", {MUTUAL_TIMER}": "",
                '"left_eye")': f'"left_eye", callback_group={MUTUAL_TIMER})',
                '"right_eye")': f'"right_eye", callback_group={MUTUAL_TIMER})',
            },
            "`/left_eye` was not answered",
            "say who waits",
        ),
        # One group for all of them is the default group again.
        (
            {
                "        self.counter = 0\n": f"        self.counter = 0\n        group = {MUTUAL_TIMER}\n",
                f"self.timer_callback, {MUTUAL_TIMER}": "self.timer_callback, group",
                "self.eye_callback)": "self.eye_callback, callback_group=group)",
            },
            "`/left_eye` was not answered",
            "say who waits",
        ),
        (
            {"Trigger.Request())\n": "Trigger.Request(), timeout_sec=0.05)\n", f", {MUTUAL_TIMER}": ""},
            "to `/left_eye` was answered at 1.2 s, not at 1.1 s",
            "",
        ),
        (
            {"self.left.call(": "self.left.call_async(", "self.right.call(": "self.right.call_async("},
            "`/right_eye` was asked at 1 s, not at 1.1 s",
            "",
        ),
        (
            {"        self.right.call(Trigger.Request())\n": ""},
            "`/right_eye` was never asked",
            "to come from the service",
        ),
        ({"time.sleep(0.1)": "pass"}, "was answered at 1 s, not at 1.1 s", ""),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "slow-service": [
        ({SLOW_GROUP: ")"}, "With `takes:=0.35`, the motor: counter 11 came at 1.35 s", "unless you give them others"),
        ({", MultiThreadedExecutor())": ")"}, "counter 11 came at 1.35 s", "a single-threaded executor calls nothing"),
        ({"MultiThreadedExecutor()": "MultiThreadedExecutor(1)"}, "counter 11 came at 1.35 s", "calls nothing"),
        (
            {MUTUAL_TIMER: "ReentrantCallbackGroup()", MUTUAL_IMPORT: "import ReentrantCallbackGroup"},
            "With `takes:=1.3`: the request of 2 s to `/take_picture` was answered at 3.3 s, not at 3.6 s",
            "one picture at a time",
        ),
        (
            {
                SLOW_GROUP: ",\n            callback_group=group)",
                "        self.commands = 0\n": f"        self.commands = 0\n        group = {MUTUAL_TIMER}\n",
                "self.motor_callback)": "self.motor_callback, group)",
            },
            "counter 11 came at 1.35 s",
            "in the same mutually exclusive group",
        ),
        ({"        time.sleep(self.takes)\n": ""}, "was answered at 1 s, not at 1.35 s", "takes its time for it"),
        ({"time.sleep(self.takes)": "time.sleep(0.35)"}, "was answered at 1.35 s, not at 2.3 s", "takes its time"),
        ({"        self.create_timer(1.0, self.ask_callback)\n": ""}, "was never asked", "from the service"),
        (
            {"1.0, self.ask": "2.0, self.ask"},
            "`/take_picture` was asked 2 times in 5.05 s, not 5 times",
            "not to change",
        ),
        (
            {"def picture_callback": "async def picture_callback", SLOW_GROUP: ")", ", MultiThreadedExecutor())": ")"},
            "counter 11 came at 1.35 s",
            "a single-threaded executor",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
    "cancel-a-goal": [
        ({"cancel_requested": "cancel_requested()"}, "aborted (6) at 1 s", "`execute_callback` failed: `'bool' object"),
        ({"self.goal.cancel_goal_async()": "pass  # "}, "was reached (4) at 5 s", "The client cancels the goal"),
        (
            {"            cancel_callback=self.may_cancel)\n": "            )\n"},
            "Cancelled at 3.2 s: the goal was reached (4) at 5 s, not cancelled (5)",
            "cancels no goal",
        ),
        ({"CancelResponse.ACCEPT": "CancelResponse.REJECT"}, "reached (4) at 5 s, not cancelled", "cancels no goal"),
        (
            {"        return CancelResponse.ACCEPT\n": "        pass\n"},
            "reached (4)",
            "returns `CancelResponse.ACCEPT`",
        ),
        ({LOOKS: ""}, "was reached (4) at 5 s, not cancelled (5)", "look at `is_cancel_requested` before each number"),
        (
            {"                goal.canceled()\n": ""},
            "the goal was aborted (6) at 3.5 s, not cancelled (5)",
            "without saying how it ended",
        ),
        ({"goal.canceled()": "goal.abort()"}, "was aborted (6) at 3.5 s", "without saying how it ended"),
        ({"goal.canceled()": "goal.succeed()"}, "was reached (4) at 3.5 s", "It succeeded early:"),
        (
            {"sequence=numbers)\n            numbers": "sequence=[])\n            numbers"},
            "the result has 0 numbers, not 7",
            "Return the numbers that the server has",
        ),
        (
            {
                LOOKS: "",
                "        numbers = [0, 1]\n": "        numbers = [0, 1]\n"
                + LOOKS.replace("            ", "        ", 1),
            },
            "reached (4) at 5 s",
            "before each number",
        ),
        ({SLEEPS_HALF: "            time.sleep(1.0)\n"}, "cancelled (5) at 4 s, not at 3.5 s", "0.5 s for each"),
        ({", MultiThreadedExecutor())": ")"}, "the node stopped", ""),
        ({SUCCEEDS: ""}, "Not cancelled: the goal was aborted (6) at 5 s", "`goal.succeed()`"),
        (
            {"if goal.is_cancel_requested": "if len(numbers) > 6"},
            "Not cancelled: the goal was aborted (6) at 3.5 s",
            "",
        ),
        (
            {"if goal.is_cancel_requested": "if len(numbers) == 7 and goal.is_cancel_requested"},
            "Cancelled at 2.2 s: the goal was cancelled (5) at 3.5 s, not at 2.5 s",
            "Look before each number",
        ),
        (FOR_ROS_1, "This node is for ROS 1", "This exercise is on ROS 2"),
    ],
}
