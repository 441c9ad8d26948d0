"""Answers to the exercises, right and wrong: whole texts, or the solution with some of its text replaced."""

from __future__ import annotations

import answers_ros2

Answer = str | dict[str, str]

# --- predictions ------------------------------------------------------------------------------------------------------

TIMER, LOOP, BUSY = "timer = [0.4, 0.8, 1.2]", "\nloop = [0.0, 0.25, 0.5]", "busy_loop = [0.0, 0.25, 0.5]"
ONE, EIGHTEEN = "after_1_0_seconds = [2.2, 2.2, 2.4]", "after_1_8_seconds = [3.0, 3.4, 3.8]"
CPP_SHORT, CPP_LONG, KEPT = (
    "after_0_6_seconds = [1.8, 2.0, 2.4]",
    "after_1_0_seconds = [2.2, 2.6, 3.0]",
    "not_kept = []",
)


def times(found: str, *wrong: object) -> dict[str, str]:
    """A prediction replaced by another."""
    return {found: f"{found.partition(' = ')[0]} = {list(wrong)}"}


# What stands for numpy's arrays and their numbers, which a page lacks.
ARRAY = """class Array:
    def __init__(self, value):
        self.value = value
    def tolist(self):
        return self.value
"""

PLAIN_HEARD, LATCHED_HEARD = "without_latch = [2, 3, 4]", "with_latch = [1, 2, 3]"
THREE, SLOW_HEARD = "three_at_once = [3]", "slow_callback = [0, 3, 6]"

# --- nodes ------------------------------------------------------------------------------------------------------------

DO_SPIN = "    rospy.spin()"
NODE = 'import rospy\nrospy.init_node("n")\n'


def say(counter: str, tag: str = "SPINNER PY NODE") -> str:
    """The line that prints a counter."""
    return f'rospy.loginfo("[{tag}] counter = " + str({counter}))'


# A timer whose callback is a function.
PLAIN = f"""{NODE}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
timer = rospy.Timer(rospy.Duration(PERIOD), callback)
rospy.spin()
"""

# A timer that is made by a generator.
LAMBDA = f"""{NODE}from itertools import count
counts = count(1)
rospy.Timer(rospy.Duration(PERIOD), lambda event: {say("next(counts)")})
rospy.spin()
"""

# It prints by other means than a log line, and logs an error that it has caught.
CAUGHT = """
import rospy
class Spinner:
    counter = 0
    def __call__(self, event):
        self.counter += 1
        try:
            [][self.counter]
        except IndexError:
            rospy.logwarn("Exception in thread Thread-1:", exc_info=True)
        print("[SPINNER PY NODE] counter = %d" % self.counter)
def main():
    rospy.init_node("spinner")
    rospy.Timer(period=rospy.Duration(nsecs=int(PERIOD * 1e9)), callback=Spinner())
    rospy.spin()
main()
"""

# A loop that sleeps first.
SLEEPS_FIRST = f"""{NODE}rate = rospy.Rate(1 / PERIOD)
count = 0
while not rospy.is_shutdown():
    rate.sleep()
    count += 1
    {say("count")}
"""

# A thread of its own beside spin().
THREAD = f"""import threading
{NODE}def run():
    for count in range(1, 1000):
        rospy.sleep(PERIOD)
        {say("count")}
threading.Thread(target=run, daemon=True).start()
rospy.spin()
"""


def at(period: str, *nodes: str) -> list[Answer]:
    """Nodes with a period."""
    return [node.replace("PERIOD", period) for node in nodes]


HEART = f"""
beats = 0
def heartbeat(event):
    global beats
    beats += 1
    {say("beats", "HEARTBEAT")}
rospy.Timer(rospy.Duration(1), heartbeat)
"""


def counts(body: str, rest: str = "rospy.spin()\n") -> str:
    """A node of exercise 6 around what its counting callback does."""
    callback = "\n".join(f"    {line}" for line in body.splitlines())
    head = "import sys, threading, rospy\nrospy.init_node('n')\ncount = 0\ndef callback(event):\n    global count\n"
    return f"{head}{callback}\n{HEART}timer = rospy.Timer(rospy.Duration(0.5), callback)\n{rest}"


COUNT = f"count += 1\n{say('count')}\n"

PARAMETER = "frequency_in_hz = rospy.get_param"
TWO_RATES_LOOP = f"""{NODE}fast = 0
def callback(event):
    global fast
    fast += 1
    {say("fast", "FAST")}
rospy.Timer(rospy.Duration(0.1), callback)
slow = 0
SLOW
"""
SLOW_LOOP = f"""rate = rospy.Rate(2)
while not rospy.is_shutdown():
    rate.sleep()
    slow += 1
    {say("slow", "SLOW")}"""

WHILE_LATE = "        while deadline < time.monotonic():\n            deadline += period\n"
SLEEP = "        time.sleep(deadline - time.monotonic())"


def overrun(after: str, before: str = "") -> str:
    """A loop of exercise 10, with what comes after its work."""
    lines = "\n".join(f"    {line}" for line in after.splitlines())
    return f"""import math, time
{NODE}work = rospy.get_param("~work")
start = deadline = time.monotonic()
count = 0
{before}
while not rospy.is_shutdown():
    count += 1
    {say("count")}
    if count == 3:
        rospy.sleep(work)
{lines}
"""


def parts(count: str, report: str, made: str = "", head: str = "") -> str:
    """A node of exercise 11."""

    def body(text: str) -> str:
        return "\n".join(f"        {line}" for line in text.splitlines())

    return f"""import queue, threading
import rospy
{head}
class Node:
    def __init__(self):
        self.parts = 0
{body(made or "pass")}
        rospy.Timer(rospy.Duration(0.1), self.count)
        rospy.Timer(rospy.Duration(0.5), self.report)
    def count(self, event):
{body(count)}
    def report(self, event):
{body(report)}
rospy.init_node("n")
node = Node()
rospy.spin()
"""


SAY_PARTS = 'rospy.loginfo("[SPINNER PY NODE] parts = " + str(parts))'
TAKE_PARTS = SAY_PARTS.replace("str(parts)", 'str((self.parts, setattr(self, "parts", 0))[0])')
LOCK = "self.lock = threading.Lock()"
LOCKED_COUNT = "with self.lock:\n    self.parts += 1"
LOCKED_REPORT = f"with self.lock:\n    parts = self.parts\n    self.parts = 0\nrospy.sleep(0.05)\n{SAY_PARTS}"

HOOK = "    rospy.on_shutdown(lambda: motor.drive(0.0))\n"
ASKS = "        if not rospy.is_shutdown():\n            motor.drive(speed)\n"
DRIVES = "        motor.drive(speed)\n"
WHILE = "    while not rospy.is_shutdown():\n"
PASS = "        speed = read_sensor()\n" + ASKS + "        rate.sleep()"
RATE = "    rate = rospy.Rate(10)\n"
FINALLY = (
    RATE + "    try:\n        while not rospy.is_shutdown():\n            speed = read_sensor()\n"
    "            motor.drive(speed)\n            rate.sleep()\n    finally:\n        motor.drive(0.0)"
)
HOOKED = {FINALLY: HOOK + RATE + WHILE + PASS}  # the solution with a hook and a question in place of the ``finally``

MISSING = "missing = int(lateness.to_sec() / 0.4)"

PUBLISHER = 'self.publisher = rospy.Publisher("counter", UInt32, queue_size=10)'
PUBLISH = "self.publisher.publish(self.counter)"
IN_CALLBACK = {  # the publisher is made in the callback
    f"        {PUBLISHER}\n": "",
    PUBLISH: f"{PUBLISHER}\n        {PUBLISH}",
}
LISTENS = f"""{NODE}from std_msgs.msg import UInt32
rospy.Subscriber("counter", UInt32, lambda message: rospy.loginfo("[LISTENER] counter = %d", message.data))
publisher = rospy.Publisher("/counter", UInt32, queue_size=1)
"""

GOAL = "        self.publisher.publish(7)"
LATCHES = "latch=True, "


def planner(publishing: str, latch: str = "") -> dict[str, str]:
    """The solution of exercise 17 with a planner that publishes in another way."""
    lines = "\n".join(f"        {line}" for line in publishing.splitlines())
    return {LATCHES: latch, GOAL: lines}


WAITS = "while not self.publisher.get_num_connections():\n    rospy.sleep(0.1)\nself.publisher.publish(7)"
LISTENER = """        class Listener(rospy.SubscribeListener):
            def peer_subscribe(self, topic_name, topic_publish, peer_publish):
                peer_publish(UInt32(7))
        self.publisher = rospy.Publisher("goal", UInt32, Listener(), queue_size=1)"""

SIZE = ", queue_size=1)"
NEWEST = "self.positionCallback, queue_size=1)"
STEP = """        rospy.loginfo("[CONTROLLER] position = " + str(message.data))
        rospy.sleep(0.33)  # the computation"""
STORES = {  # the callback stores the position, and LOOP uses it
    SIZE: ")\n        self.newest = None",
    STEP: "        self.newest = message.data",
}
LOOPS = """    while not rospy.is_shutdown():
        if controller.newest is None:
            rospy.sleep(0.01)
            continue
        rospy.loginfo("[CONTROLLER] position = " + str(controller.newest))
        rospy.sleep(0.33)"""

# --- right ------------------------------------------------------------------------------------------------------------

RIGHT: dict[str, list[Answer]] = {
    "first-ticks": [
        {TIMER: "timer = (0.4, 0.8, 1.2)"},
        {TIMER: "timer = [0.4 * n for n in range(1, 4)]", LOOP: "\nloop = [n / 4 for n in range(3)]"},
        {TIMER: "timer = [n * 0.4 for n in (1, 2, 3)]"},
        {BUSY: "busy_loop = loop"},
        {TIMER: "from fractions import Fraction\ntimer = [float(Fraction(n, 5)) for n in (2, 4, 6)]"},
        {LOOP: "\nloop = [0, .25, .5]\nprint(loop)"},
        {TIMER: "from fractions import Fraction\ntimer = [Fraction(n, 5) for n in (2, 4, 6)]"},
        {LOOP: "\nfrom decimal import Decimal\nloop = [n * Decimal('0.25') for n in range(3)]"},
        {TIMER: "class A(float):\n    pass\ntimer = [A(0.4), 0.8, 1.2]"},
        {TIMER: "import numpy\ntimer = 0.4 * numpy.arange(1, 4)", LOOP: "\nloop = list(timer / timer[0] / 4 - 0.25)"},
        {TIMER: f"{ARRAY}timer = Array([0.4, 0.8, 1.2])"},
        {TIMER: f"{ARRAY}timer = [Array(0.4), Array(0.8), 1.2]"},
    ],
    "after-a-slow-callback": [
        {ONE: "after_1_0_seconds = (2.2, 2.2, 2.4)"},
        {EIGHTEEN: "back = 1.2 + 1.8\nafter_1_8_seconds = [back + n * 0.4 for n in range(3)]"},
        {EIGHTEEN: "after_1_8_seconds = [3, 3.4, 3.8]"},
        {ONE: "after_1_0_seconds = [2.2] * 2 + [2.4]"},
        {EIGHTEEN: "after_1_8_seconds = list(map(float, '3.0 3.4 3.8'.split()))"},
        {ONE: "after_1_0_seconds = [2.201, 2.199, 2.4]"},
    ],
    "cpp-ticks": [
        {KEPT: "not_kept = ()"},
        {KEPT: "not_kept = list()"},
        {CPP_SHORT: "after_0_6_seconds = [1.2 + 0.6, 2, 2.4]"},
        {CPP_LONG: "after_1_0_seconds = tuple(2.2 + n * 0.4 for n in range(3))"},
        {CPP_LONG: "after_1_0_seconds = [2.2, 2.6, 3]", KEPT: "not_kept = []"},
    ],
    "ten-hertz": [
        {"= 0.1": "= 1 / 10"},
        {"rospy.Duration(timer_delta_t_in_seconds)": "rospy.Duration(0, 100000000)"},
        *at("0.1", PLAIN, LAMBDA, CAUGHT, SLEEPS_FIRST, THREAD),
    ],
    "fire-once": [
        {", oneshot=True": ", True"},
        *at("1.5", *(node.replace("callback)", "callback, oneshot=True)") for node in (PLAIN,))),
        *at("1.5", CAUGHT.replace("callback=Spinner()", "callback=Spinner(), oneshot=True")),
        *at("1.5", PLAIN.replace(f"    {say('count')}", f"    {say('count')}\n    timer.shutdown()")),
        *at("1.5", PLAIN.replace("rospy.spin()", "rospy.sleep(2)\ntimer.shutdown()\nrospy.spin()")),
        *at(
            "1.5",
            PLAIN.replace("rospy.spin()", "while not count:\n    rospy.sleep(0.1)\ntimer.shutdown()\nrospy.spin()"),
        ),
        {"self.timerCallback, oneshot": "lambda event: self.timerCallback(event), oneshot"},
    ],
    "stop-after-five": [
        counts(COUNT + "if count >= 5:\n    timer.shutdown()"),
        counts(COUNT, "rospy.sleep(2.75)\ntimer.shutdown()\nrospy.spin()\n"),
        counts(COUNT).replace("    beats += 1", "    beats += 1\n    if count == 5: timer.shutdown()"),
        counts(COUNT, "while count < 5:\n    rospy.sleep(0.1)\ntimer.shutdown()\nrospy.spin()\n"),
        counts(
            COUNT,
            "rate = rospy.Rate(20)\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
            "    if count == 5: timer.shutdown()\n",
        ),
        counts(COUNT, "threading.Timer(2.6, timer.shutdown).start()\nrospy.spin()\n"),
        counts(COUNT, "rospy.Timer(rospy.Duration(2.7), lambda e: timer.shutdown(), oneshot=True)\nrospy.spin()\n"),
        counts("rospy.loginfo('Traceback (most recent call last):')\n" + COUNT + "if count == 5: timer.shutdown()"),
    ],
    "loop-to-timer": [
        *at("0.5", PLAIN, LAMBDA, CAUGHT),
        *at(
            "0.5",
            PLAIN.replace(
                "rospy.spin()",
                "import threading\nthread = threading.Thread(target=rospy.spin)\nthread.start()\nthread.join()",
            ),
        ),
        *at("0.5", PLAIN.replace("rospy.spin()", "def main():\n    rospy.spin()\nmain()")),
        {"        frequency_in_hz = 2.0\n": "        frequency_in_hz = rospy.get_param('~frequency', 2.0)\n"},
    ],
    "frequency-parameter": [
        {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = float(rospy.get_param("~frequency", 2))'},
        {"~frequency": "/spinner_py_node/frequency"},
        {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = rospy.get_param(rospy.get_name() + "/frequency", 2.0)'},
        {
            PARAMETER + '("~frequency", 2.0)': "try:\n            frequency_in_hz = rospy.get_param('~frequency')\n"
            "        except KeyError:\n            rospy.logwarn('no frequency', exc_info=True)\n"
            "            frequency_in_hz = 2.0"
        },
        {
            PARAMETER + '("~frequency", 2.0)': "frequency_in_hz = 2.0\n        if rospy.has_param('~frequency'):\n"
            "            frequency_in_hz = rospy.get_param('~frequency')"
        },
        *at("(1 / rospy.get_param('~frequency', 2))", PLAIN, SLEEPS_FIRST),
    ],
    "two-rates": [
        TWO_RATES_LOOP.replace("SLOW\n", SLOW_LOOP + "\n", 1).replace("0\nSLOW", "0\n" + SLOW_LOOP),
        TWO_RATES_LOOP.replace(
            "\nSLOW\n",
            "\nwhile True:\n    rospy.sleep(0.5)\n    if rospy.is_shutdown(): break\n"
            f"    slow += 1\n    {say('slow', 'SLOW')}\n",
        ),
        TWO_RATES_LOOP.replace("\nSLOW\n", "\nrospy.spin()\n").replace(
            say("fast", "FAST"), f"{say('fast', 'FAST')}\n    if fast % 5 == 0: {say('fast // 5', 'SLOW')}"
        ),
        f"""{NODE}rate = rospy.Rate(10)
passes = 0
while not rospy.is_shutdown():
    rate.sleep()
    passes += 1
    {say("passes", "FAST")}
    if passes % 5 == 0:
        {say("passes // 5", "SLOW")}
""",
        f"""{NODE}from functools import partial
from itertools import count
def call(tag, counts, event):
    rospy.loginfo("[%s] counter = %d", tag, next(counts))
for tag, period in ("FAST", 0.1), ("SLOW", 0.5):
    rospy.Timer(rospy.Duration(period), partial(call, tag, count(1)))
rospy.spin()
""",
        f"""import threading
{NODE}def run(tag, hz):
    rate = rospy.Rate(hz)
    for number in range(1, 1000):
        rate.sleep()
        rospy.loginfo("[%s] counter = %d", tag, number)
threading.Thread(target=run, args=("FAST", 10), daemon=True).start()
threading.Thread(target=run, args=("SLOW", 2), daemon=True).start()
rospy.spin()
""",
    ],
    "survive-an-overrun": [
        overrun(
            "deadline += 0.5\nwhile deadline <= time.monotonic() - 1e-9:\n    deadline += 0.5\n"
            "time.sleep(max(0, deadline - time.monotonic()))"
        ),
        overrun("now = time.monotonic() - start\nrospy.sleep((math.floor(now / 0.5 + 1e-6) + 1) * 0.5 - now)"),
        overrun("rospy.sleep(0.5 - (time.monotonic() - start) % 0.5)"),
        overrun(
            "late = time.monotonic() - deadline\ndeadline += max(1, math.ceil(late / 0.5)) * 0.5\n"
            "rospy.sleep(deadline - time.monotonic())"
        ),
        overrun(
            "deadline = deadline + 0.5\nif deadline < time.monotonic():\n    rospy.logwarn('late')\n"
            "    deadline += math.ceil((time.monotonic() - deadline) / 0.5) * 0.5\n"
            "time.sleep(deadline - time.monotonic())"
        ),
        overrun(
            "try:\n    deadline += 0.5\n    time.sleep(deadline - time.monotonic())\n"
            "except ValueError:\n    rospy.logerr('late', exc_info=True)\n"
            "    while deadline < time.monotonic():\n        deadline += 0.5\n"
            "    time.sleep(deadline - time.monotonic())"
        ),
    ],
    "share-data": [
        parts(LOCKED_COUNT, LOCKED_REPORT, LOCK.replace("Lock", "RLock")),
        parts(
            LOCKED_COUNT,
            f"with self.lock:\n    parts = self.parts\n    rospy.sleep(0.05)\n    {SAY_PARTS}\n    self.parts = 0",
            LOCK,
        ),
        parts("self.lock.acquire()\ntry:\n    self.parts += 1\nfinally:\n    self.lock.release()", LOCKED_REPORT, LOCK),
        parts(
            "self.queue.put(1)",
            f"parts = 0\nwhile not self.queue.empty():\n    parts += self.queue.get()\nrospy.sleep(0.05)\n{SAY_PARTS}",
            "self.queue = queue.Queue()",
        ),
        parts(
            LOCKED_COUNT,
            f"with self.lock:\n    parts = self.parts\nrospy.sleep(0.05)\n{SAY_PARTS}\n"
            "with self.lock:\n    self.parts -= parts",
            LOCK,
        ),
        parts(
            "with self.turn:\n    self.parts += 1\n    self.turn.notify()",
            LOCKED_REPORT.replace("lock", "turn"),
            "self.turn = threading.Condition()",
        ),
        parts(
            "with lock:\n    self.parts += 1",
            LOCKED_REPORT.replace("self.lock", "lock"),
            head="lock = threading.Semaphore()",
        ),
        # What one thread writes and the other only reads needs no lock.
        parts(
            "self.parts += 1",
            f"now = self.parts\nparts = now - self.told\nself.told = now\n{SAY_PARTS}",
            "self.told = 0",
        ),
    ],
    "stop-the-motor": [
        HOOKED,
        {
            **HOOKED,
            HOOK: "",
            WHILE + PASS: "    try:\n        while not rospy.is_shutdown():\n            motor.drive(read_sensor())\n"
            "            rate.sleep()\n    finally:\n        motor.drive(0.0)\n",
        },
        {**HOOKED, HOOK: "    def stop():\n        motor.drive(0)\n    rospy.on_shutdown(stop)\n"},
        {**HOOKED, ASKS: "        if rospy.is_shutdown():\n            break\n" + DRIVES},
        {**HOOKED, HOOK: "    import atexit\n    atexit.register(motor.drive, 0.0)\n"},
        {
            **HOOKED,
            "    def drive(self, speed):\n": "    stopped = False\n\n    def drive(self, speed):\n"
            "        if self.stopped: return\n        self.stopped = speed == 0\n",
            ASKS: DRIVES,
        },
        {
            **HOOKED,
            WHILE + PASS: "    try:\n        while not rospy.is_shutdown():\n            speed = read_sensor()\n"
            "            if not rospy.is_shutdown(): motor.drive(speed)\n            rate.sleep()\n"
            "    except RuntimeError:\n        rospy.logerr('no sensor', exc_info=True)\n",
        },
        {
            **HOOKED,
            HOOK: "",
            WHILE + PASS: "    def drive(event):\n        try:\n            speed = read_sensor()\n"
            "        except RuntimeError as error:\n            rospy.signal_shutdown(str(error))\n            return\n"
            "        if not rospy.is_shutdown(): motor.drive(speed)\n"
            "    rospy.Timer(rospy.Duration(0.1), drive)\n    rospy.spin()\n    motor.drive(0.0)\n",
        },
    ],
    "missing-ticks": [
        {MISSING: "missing = float(int(lateness.to_sec() / 0.4))"},
        {MISSING: "missing = lateness // rospy.Duration(0.4)"},
        {MISSING: "missing = int(lateness.to_nsec() // 400000000)"},
        {"= event.current_real -": "= rospy.Time.now() -"},
        {MISSING: "missing = 0\n        while (missing + 1) * 0.4 <= lateness.to_sec():\n            missing += 1"},
        {MISSING: "import math\n        missing = math.floor(lateness.to_sec() / 0.4)"},
        {'rospy.loginfo("[SPINNER PY NODE] missing = " + str(missing))': 'print(f"[LATE] missing = {missing}")'},
    ],
    "name-the-fault": [
        {'"B"': '"b"', '"E"': "'e'"},
        {'"B"': '" B "'},
        {'"E"': '"E: an exception"', '"C"': '"**C**"'},
        {'"D"': '"(D)"'},
        {'"C"': '"C."'},
        {'log_1 = "B"': "", 'log_2 = "E"': 'log_1, log_2 = "BE"'},
    ],
    "what-is-heard": [
        {PLAIN_HEARD: "without_latch = (2, 3, 4)"},
        {LATCHED_HEARD: "with_latch = range(1, 4)"},
        {THREE: "three_at_once = (3,)"},
        {SLOW_HEARD: "slow_callback = [0.0, 3.0, 6.0]"},
        {SLOW_HEARD: "slow_callback = [3 * n for n in range(3)]", PLAIN_HEARD: "without_latch = (2, 3, 4)"},
    ],
    "publish-the-counter": [
        {"publish(self.counter)": "publish(data=self.counter)"},
        {"publish(self.counter)": "publish(UInt32(self.counter))"},
        {"UInt32, queue_size=10": "UInt32, latch=True, queue_size=1"},
        {PUBLISHER: PUBLISHER.replace('"counter"', '"/counter"'), "Duration(0.2)": "Duration(1 / 5)"},
        {PUBLISHER: PUBLISHER.replace(", queue_size=10", "")},
        LISTENS + "for count in range(1, 100):\n    rospy.sleep(0.2)\n    if rospy.is_shutdown():\n        break\n"
        "    publisher.publish(count)\n",
        LISTENS + "rate = rospy.Rate(5)\ncount = 0\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
        "    count += 1\n    publisher.publish(count)\n",
        LISTENS + "from itertools import count\ncounts = count(1)\n"
        "rospy.Timer(rospy.Duration(0.2), lambda event: publisher.publish(next(counts)))\nrospy.spin()\n",
    ],
    "late-subscriber": [
        {LATCHES: "latch=1, "},
        {LATCHES: "", '"goal", UInt32, queue_size': '"goal", UInt32, latch=True, queue_size'},
        planner(WAITS),
        planner(
            f"import threading\ndef wait():\n    {WAITS.replace(chr(10), chr(10) + '    ')}\n"
            "threading.Thread(target=wait, daemon=True).start()"
        ),
        planner(
            "def look(event):\n    if self.publisher.get_num_connections():\n        timer.shutdown()\n"
            "        self.publisher.publish(7)\ntimer = rospy.Timer(rospy.Duration(0.1), look)"
        ),
        {f'        self.publisher = rospy.Publisher("goal", UInt32, {LATCHES}queue_size=10)\n{GOAL}': LISTENER},
        {GOAL: "        self.publisher.publish(UInt32(data=7))"},
    ],
    "newest-position": [
        {"Subscriber(": "Subscriber(name=", "UInt32, self.pos": "data_class=UInt32, callback=self.pos"},
        {**STORES, DO_SPIN: LOOPS},
        {
            **STORES,
            SIZE: ")\n        self.newest = None\n        rospy.Timer(rospy.Duration(0.33), self.step)\n\n"
            "    def step(self, event):\n        if self.newest is None:\n            return\n"
            '        rospy.loginfo("[CONTROLLER] position = " + str(self.newest))\n        rospy.sleep(0.33)',
        },
        {
            **STORES,
            SIZE: ")\n        import threading\n        self.turn = threading.Condition()\n        self.newest = None\n"
            "        threading.Thread(target=self.steps, daemon=True).start()\n\n    def steps(self):\n"
            "        while True:\n            with self.turn:\n                self.turn.wait()\n"
            '            rospy.loginfo("[CONTROLLER] position = " + str(self.newest))\n            rospy.sleep(0.33)',
            STEP: "        with self.turn:\n            self.newest = message.data\n            self.turn.notify()",
        },
        {
            **STORES,
            SIZE: ")\n        import queue, threading\n        self.queue = queue.LifoQueue()\n"
            "        threading.Thread(target=self.steps, daemon=True).start()\n\n    def steps(self):\n"
            "        while True:\n            newest = self.queue.get()\n"
            '            rospy.loginfo("[CONTROLLER] position = " + str(newest))\n            rospy.sleep(0.33)',
            STEP: "        self.queue.put(message.data)",
        },
        {"rospy.sleep(0.33)": "rospy.sleep(0.35)"},
    ],
    "rostopic-hz": [
        {'"C"': '"c"', '"D"': "'d'"},
        {'"E"': '" E "'},
        {'"B"': '"(B)"'},
        {'"C"': '"C."'},
        {'report_1 = "C"': "", 'report_2 = "D"': 'report_1, report_2 = "CD"'},
    ],
}

# --- wrong ------------------------------------------------------------------------------------------------------------

STOP_ITSELF = "Stop the timer itself"
SPIN_SLEEPS = "    while not rospy.is_shutdown():\n        rospy.sleep(0.5)\n"
NOT_AT_ONCE = "A timer waits for one period before its first call"
NOT_A_FREQUENCY = "the period is 1 / frequency"
OWN_COUNTER = "a counter of its own"
NO_QUEUE = "There is none: ticks are lost here"
WHOLE = "the number is whole"
PRIVATE = "Does the name begin with `~`?"

# What it is, what the feedback says is wrong, and the hint that it should get.
WRONG: dict[str, list[tuple[Answer, str, str]]] = {
    "first-ticks": [
        (times(TIMER, 0.0, 0.4, 0.8), "The timer: not 0 s, 0.4 s, 0.8 s", NOT_AT_ONCE),
        (times(TIMER, 2.5, 5, 7.5), "The timer: not 2.5 s", "This takes 0.4 for a frequency"),
        (times(LOOP, 0.25, 0.5, 0.75), "The loop: not 0.25 s", "makes its first pass immediately"),
        (times(LOOP, 0, 4, 8), "The loop: not 0 s, 4 s, 8 s", "This takes 4 for a period"),
        (times(BUSY, 0, 0.35, 0.7), "not 0 s, 0.35 s, 0.7 s", "the work is a part of the period"),
        (times(BUSY, 0.1, 0.35, 0.6), "not 0.1 s", "This is when the work ends"),
        (times(TIMER, 0.4, 0.8), "3 times are asked for, not 2", "Does a timer call back before"),
        ({TIMER: "timer = '0.4, 0.8, 1.2'"}, "not a value of type `str`", "Write it as `[1.0, 2.0, 3.0]`"),
        ({LOOP: "\nloop = ..."}, "The loop: there is no prediction yet", "Give `loop` a list of times"),
        (times(TIMER, 0.4, 0.9, 1.2), "the second of these times is not 0.9 s", "Does a timer call back before"),
        ({TIMER: "timer = [period]"}, "stopped in line 2: `NameError: name 'period'", "Python names what it did"),
        ({TIMER: "timer = range(10**9)"}, "3 times are asked for, not 100", "Does a timer call"),
        ({TIMER: "class A(list):\n    pass\ntimer = A([0.4, 0.8, 1.2])"}, "a value of type `A`", "Write it as"),
        ({TIMER: "timer = [True, 0.8, 1.2]"}, "not one that holds something else", "Write it as"),
        ({TIMER: f"{ARRAY}timer = Array(['0.4', '0.8', '1.2'])"}, "a value of type `Array`", "Write it as"),
    ],
    "after-a-slow-callback": [
        (times(ONE, 1.6, 2.0, 2.4), "Blocked for 1.0 s: not 1.6 s", "keeps its timer busy until it returns"),
        (times(ONE, 2.2, 2.6, 3.0), "not 2.2 s, 2.6 s, 3 s", "This is what roscpp does"),
        (times(ONE, 2.2, 2.4, 2.8), "not 2.2 s, 2.4 s", "rospy makes up for short delays"),
        (times(EIGHTEEN, 3.0, 3.0, 3.0), "Blocked for 1.8 s: not 3 s, 3 s, 3 s", NO_QUEUE),
        (times(EIGHTEEN, 3.0, 3.2, 3.6), "not 3 s, 3.2 s", "rospy begins a new one"),
        (times(EIGHTEEN, 3.0, 3.0, 3.2), "not 3 s, 3 s, 3.2 s", "This one is too long to be made up for"),
        (times(EIGHTEEN, 1.6, 2.0, 2.4), "not 1.6 s", "keeps its timer busy"),
        (
            times(EIGHTEEN, 3.0, 3.5, 4.0),
            "the second of these times is not 3.5 s",
            "Which ticks are overdue when it returns?",
        ),
        ({EIGHTEEN: "after_1_8_seconds = [3,0 3,4 3,8]"}, "is not Python: invalid syntax", "nothing ran"),
        ({"after_1_8_seconds": "after_2_seconds"}, "there is no prediction yet", "Give `after_1_8_seconds` a list"),
        ({ONE: "after_1_0_seconds = 2.2"}, "not a value of type `float`", "Write it as"),
    ],
    "cpp-ticks": [
        (times(CPP_SHORT, 1.6, 2.0, 2.4), "Blocked for 0.6 s: not 1.6 s", "keeps its timer busy"),
        (times(CPP_SHORT, 1.8, 2.2, 2.6), "not 1.8 s, 2.2 s", "only if the call after the next one is overdue"),
        (times(CPP_LONG, 2.2, 2.2, 2.4), "not 2.2 s, 2.2 s", "This is what rospy does"),
        (times(CPP_LONG, 2.2, 2.4, 2.8), "not 2.2 s, 2.4 s", "roscpp begins a new one"),
        (times(CPP_LONG, 1.6, 2.0, 2.4), "Blocked for 1.0 s: not 1.6 s", "keeps its timer busy"),
        (times(KEPT, 0.4, 0.8, 1.2), "that nobody keeps: not 0.4 s", "In C++ a timer ends with the last"),
        (times(KEPT, 0.0), "that nobody keeps: not 0 s", "the last `ros::Timer`"),
        ({KEPT: "not_kept = None"}, "that nobody keeps: there is no prediction", "Give `not_kept` a list"),
        ({KEPT: "not_kept = 0"}, "not a value of type `int`", "Write it as"),
        (times(CPP_SHORT, 1.8, 2.0), "3 times are asked for, not 2", "Which tick is overdue"),
    ],
    "ten-hertz": [
        ({"= 0.1": "= 10"}, "no counter was printed", NOT_A_FREQUENCY),
        ({"= 0.1": "= 0.01"}, "counter 1 came at 0.01 s, not at 0.1 s", NOT_A_FREQUENCY),
        ({"= 0.1": "= 1"}, "counter 1 came at 1 s, not at 0.1 s", NOT_A_FREQUENCY),
        ({"= 0.1": "= 1 // 10"}, "timer stopped with `ZeroDivisionError: division by zero`", "a period of 0 s"),
        ({"rospy.Duration(timer_delta_t_in_seconds)": "0.1"}, "has no attribute 'to_sec'", "is a Duration"),
        ({"+= 1": "+= 10"}, "where counter 1 was due, counter 10 came", "The counter goes up by 10 each time:"),
        ({"= 0.1": "= -0.1"}, "simulated time stands still", "runs without ever sleeping"),
        ({DO_SPIN: ""}, "counter 2, due at 0.2 s, did not come", "The node ended by itself"),
        ({"+ str(self.counter))": "+ str(self.counter)); self.timerCallback(event)"}, "RecursionError", "period"),
        (
            {"self.timerCallback)": "self.timerCallback, rate=10)"},
            "unexpected keyword argument 'rate'",
            "`rospy.Timer(rospy.Duration(0.5), self.callback)`:",
        ),
    ],
    "fire-once": [
        ({", oneshot=True": ""}, "counter 2 came at 3 s; it should not have come", "has a parameter `oneshot`"),
        ({"= 1.5": "= 0.5"}, "counter 1 came at 0.5 s, not at 1.5 s", "the time until the only call"),
        ({"oneshot=True": "oneshot"}, "stopped in line 10: `NameError: name 'oneshot'", "Python names what"),
        (
            {
                ", oneshot=True": "",
                "        self.counter += 1\n": "        if self.counter: return\n        self.counter += 1\n",
            },
            "the callback was called 3 times in 5 s, where 1 would do",
            STOP_ITSELF,
        ),
        (
            {", oneshot=True": "", "str(self.counter))": "str(self.counter))\n        rospy.sleep(1e6)"},
            "a call of its callback had not returned",
            "A callback that never returns keeps its thread",
        ),
        (
            {", oneshot=True": "", "str(self.counter))": "str(self.counter))\n        raise SystemExit"},
            "its thread was ended",
            "ends the thread that the callback runs in",
        ),
        (
            {"str(self.counter))": "str(self.counter))\n        rospy.spin()"},
            "a call of its callback had not returned",
            "never returns",
        ),
        (
            f"{NODE}rospy.sleep(1.5)\n{say('1')}\nrospy.spin()",
            "not printed by the callback of a `rospy.Timer`",
            "Use a timer",
        ),
        (
            {"str(self.counter))": "str(self.counter))\n        1 / 0"},
            "in line 15: `ZeroDivisionError",
            "This line divides by 0.",
        ),
        (
            f"import threading\n{NODE}threading.Timer(1.5, lambda: {say('1')}).start()\nrospy.spin()",
            "not printed by the callback of a `rospy.Timer`",
            "Use a timer",
        ),
    ],
    "stop-after-five": [
        ({"== 5": "> 5"}, "counter 6 came at 3 s; it should not have come", "call its `shutdown()`"),
        ({"self.timer.shutdown()": "rospy.signal_shutdown('five')"}, "The heartbeat: counter", "ends the whole node"),
        (counts("if count == 5: return\n" + COUNT), "the callback was called 12 times in 6 s", STOP_ITSELF),
        (counts(COUNT + "if count == 5: sys.exit()"), "its thread was ended", "ends the thread that the callback"),
        (counts(COUNT + "if count == 5: rospy.sleep(1e6)"), "had not returned in the end", "never returns"),
        (counts(COUNT + "if count == 5: threading.Event().wait()"), "had not returned in the end", "never returns"),
        (
            {"self.timer.shutdown()": "self.timer.stop()"},
            "'Timer' object has no attribute 'stop'",
            "A `Timer` has no `stop`.",
        ),
        (
            counts(COUNT + "if count == 5: raise RuntimeError('stop')"),
            "timer stopped in line 8: `RuntimeError: stop`",
            "shutdown()",
        ),
        ({"self.timer = rospy": "rospy"}, "has no attribute 'timer'", "with its `self.`"),
        (
            counts("pass", f"for count in range(1, 6):\n    rospy.sleep(0.5)\n    {say('count')}\nrospy.spin()\n"),
            "not printed by the callback of a `rospy.Timer`",
            "Use a timer, and stop it",
        ),
        (
            counts(COUNT + "if count == 5:\n    while True: rospy.sleep(1)"),
            "had not returned in the end",
            "never returns",
        ),
        ({"rospy.Timer(rospy.Duration(1.0), self.heartbeat)": "pass"}, "The heartbeat: no counter", "Stop one timer"),
    ],
    "loop-to-timer": [
        ({DO_SPIN: ""}, "no counter was printed", "The node ended by itself"),
        (
            {"self.timerCallback)": "self.timerCallback())"},
            "missing 1 required positional argument: 'event'",
            "Pass the function on without calling it:",
        ),
        ({"(self, event)": "(self)"}, "takes 1 positional argument but 2 were given", "one argument, the event"),
        ({"1.0 / frequency_in_hz": "frequency_in_hz"}, "counter 1 came at 2 s, not at 0.5 s", "goes into a callback"),
        (
            {DO_SPIN: "    rate = rospy.Rate(2.0)\n    while not rospy.is_shutdown():\n        rate.sleep()"},
            "there still is a loop, at line 21",
            "it needs no loop around it",
        ),
        ({DO_SPIN: SPIN_SLEEPS}, "there still is a loop, at line 20", "it needs no loop around it"),
        (at("0.5", SLEEPS_FIRST)[0], "no timer calls back", "goes into a callback"),
        (at("0.5", THREAD)[0], "no timer calls back", "goes into a callback"),
        (
            at("0.5", THREAD.replace("rospy.spin()", "rospy.Timer(rospy.Duration(1), print)\nrospy.spin()"))[0],
            "was printed by a loop",
            "goes into a callback",
        ),
        (
            f"""{NODE}def callback(event):
    for count in range(1, 1000):
        {say("count")}
        rospy.sleep(0.5)
rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.spin()
""",
            "the loop is now in the callback",
            "does one pass and returns",
        ),
        (
            f"""{NODE}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
    rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
callback(None)
rospy.spin()
""",
            "counter 1 came at 0 s, not at 0.5 s",
            "goes into a callback",
        ),
        (
            f"""{NODE}count = 0
def callback(event):
    global count
    count += 1
    {say("count")}
    rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.Timer(rospy.Duration(0.5), callback, oneshot=True)
rospy.spin()
""",
            "6 timers printed the counters",
            "calls back again by itself",
        ),
    ],
    "frequency-parameter": [
        ({'"~frequency"': '"frequency"'}, "With `_frequency:=10`: counter 1 came at 0.5 s, not at 0.1 s", PRIVATE),
        ({", 2.0)": ")"}, "KeyError", "the default is in Hz"),
        ({"1.0 / frequency_in_hz": "frequency_in_hz"}, "Without the parameter: counter 1 came at 2 s", "a period that"),
        ({"1.0 / frequency_in_hz": "1 // frequency_in_hz"}, "stopped with `ZeroDivisionError", "a period of 0 s"),
        ({", 2.0)": ", 0.5)"}, "Without the parameter: counter 1 came at 2 s", "the default is in Hz"),
        ({'rospy.get_param("~frequency", 2.0)': "2.0"}, "With `_frequency:=10`: counter 1 came at 0.5 s", PRIVATE),
        (
            {PARAMETER + '("~frequency", 2.0)': 'frequency_in_hz = str(rospy.get_param("~frequency", 2.0))'},
            "TypeError: unsupported operand",
            "in Hz",
        ),
        (
            {"1.0 / frequency_in_hz": "1.0 / int(frequency_in_hz)"},
            "With `_frequency:=0.5`, the node stopped",
            "This line divides by 0.",
        ),
        ({'"~frequency"': "~frequency"}, "NameError: name 'frequency' is not defined", "Python names"),
        ({'"~frequency"': '"~period"'}, "With `_frequency:=10`: counter 1 came at 0.5 s", PRIVATE),
        (
            {
                'rospy.get_param("~frequency", 2.0)': "float(dict(map(lambda each: each.split(':='), sys.argv[1:]))"
                ".get('_frequency', 2))",
                "import rospy\n": "import sys\n\nimport rospy\n",
            },
            "With `_frequency:=10`: the node asked for no parameter",
            "in a launch file as well",
        ),
    ],
    "two-rates": [
        ({"slow_counter": "fast_counter"}, "where counter 5 was due, counter 6 came", OWN_COUNTER),
        ({"Duration(0.5)": "Duration(2)"}, "`[SLOW]`: counter 1 came at 2 s, not at 0.5 s", "as many timers"),
        (
            {"Duration(0.1)": "Duration(0.5)", "Duration(0.5), self.slow": "Duration(0.1), self.slow"},
            "`[FAST]`: counter 1 came at 0.5 s",
            "as many timers",
        ),
        (
            TWO_RATES_LOOP.replace(
                "\nSLOW\n", "\n" + SLOW_LOOP.replace("    rate.sleep()\n", "") + "\n    rate.sleep()\n"
            ),
            "`[SLOW]`: counter 1 came at 0 s",
            "as many timers",
        ),
        (
            f"{NODE}fast = slow = 0\nrate = rospy.Rate(10)\nwhile not rospy.is_shutdown():\n    rate.sleep()\n"
            f"    fast += 1\n    {say('fast', 'FAST')}\n" + SLOW_LOOP.replace("rospy.Rate", "rospy.Rate"),
            "`[SLOW]`: no counter was printed",
            "as many timers",
        ),
        (
            {"[SLOW]": "[slow]"},
            "`[SLOW]`: no counter was printed",
            "The lines should read `[SLOW] counter = 1` and so on.",
        ),
        ({"self.slowCallback)": "self.fastCallback)"}, "`[SLOW]`: no counter was printed", "callback and counter"),
        ({"        self.slow_counter = 0\n": ""}, "has no attribute 'slow_counter'", "Python names"),
        (
            {"str(self.slow_counter))": "str(self.slow_counter))\n        rospy.sleep(0.6)"},
            "`[SLOW]`: counter 2 came at 1.1 s",
            "as many timers",
        ),
    ],
    "survive-an-overrun": [
        (
            {WHILE_LATE: "", SLEEP: f"        try:\n    {SLEEP}\n        except ValueError:\n            pass"},
            "counter 4 came at 1.7 s, not at 2 s",
            "would send two commands in quick succession",
        ),
        (
            {WHILE_LATE: "", "time.sleep(deadline - time.monotonic())": "rospy.sleep(deadline - time.monotonic())"},
            "With `_work:=1.7`: counter 4 came at 2.7 s, not at 3 s",
            "two commands in quick succession",
        ),
        (
            {WHILE_LATE: "", "deadline += period": "deadline = time.monotonic() + period"},
            "counter 4 came at 2.2 s",
            "count deadlines on from the old one",
        ),
        ({WHILE_LATE: "", SLEEP: "        rospy.sleep(period)"}, "counter 4 came at 2.2 s", "has left its grid"),
        ({WHILE_LATE: ""}, "stopped in line 18: `ValueError: sleep length must be", "move the deadline on"),
        (overrun("rate.sleep()", "rate = rospy.Rate(2)"), "counter 4 came at 1.7 s", "two commands in quick"),
        (
            {WHILE_LATE: "        if deadline < time.monotonic():\n            deadline += period\n"},
            "Started with `_work:=1.7`, the node stopped in line 20: `ValueError",
            "move the deadline on",
        ),
        (
            {WHILE_LATE: "        if deadline < time.monotonic():\n            deadline = time.monotonic()\n"},
            "counter 4 came at 1.7 s",
            "has left its grid",
        ),
        (
            {"            rospy.sleep(work)": "            pass"},
            "counter 4 came at 1.5 s, not at 2 s",
            "move the deadline",
        ),
        (
            {WHILE_LATE: "        while deadline < time.monotonic():\n            pass\n"},
            "stands still",
            "without ever sleeping",
        ),
    ],
    "share-data": [
        (
            parts(LOCKED_COUNT, LOCKED_REPORT, LOCK + "\nself.parts = 1"),
            "parts have passed: some are reported twice",
            "both need one lock",
        ),
        (
            {"        with self.lock:\n            parts =": "        if True:\n            parts ="},
            "when the threads take turns at every line: the reports up to",
            "both need one lock",
        ),
        (
            {"        with self.lock:\n            self.parts += 1": "        self.parts += 1"},
            "when the threads take turns at every line",
            "both need one lock",
        ),
        (parts("self.parts += 1", f"parts = self.parts\nself.parts -= parts\n{SAY_PARTS}"), "take turns", "one lock"),
        (parts("self.parts += 1", f"parts, self.parts = self.parts, 0\n{SAY_PARTS}"), "take turns", "one lock"),
        (
            parts(
                "with threading.Lock():\n    self.parts += 1", LOCKED_REPORT.replace("self.lock", "threading.Lock()")
            ),
            "take turns",
            "one lock",
        ),
        (
            parts(
                LOCKED_COUNT, LOCKED_REPORT.replace("self.lock", "self.other"), LOCK + "\nself.other = threading.Lock()"
            ),
            "take turns",
            "one lock",
        ),
        (
            parts("self.lock.acquire()\nself.parts += 1", LOCKED_REPORT, LOCK),
            "report due at 0.5 s did not come",
            "never released",
        ),
        (
            parts(LOCKED_COUNT, f"with self.lock:\n    with self.lock:\n        parts = self.parts\n{SAY_PARTS}", LOCK),
            "the report due at 0.5 s did not come",
            "or that it has already",
        ),
        (
            parts(
                LOCKED_COUNT,
                f"with self.lock:\n    parts = self.parts\nrospy.sleep(0.05)\n{SAY_PARTS}\n"
                "with self.lock:\n    self.parts = 0",
                LOCK,
            ),
            "some are lost",
            "both need one lock",
        ),
        (
            parts(LOCKED_COUNT, f"with self.lock:\n    parts = self.parts\n{SAY_PARTS}", LOCK),
            "reported twice",
            "one lock",
        ),
        (
            parts(
                "with self.lock:\n    parts = self.parts\nwith self.lock:\n    self.parts = parts + 1",
                LOCKED_REPORT,
                LOCK,
            ),
            "take turns",
            "one lock",
        ),
        ({"        self.lock = threading.Lock()\n": ""}, "has no attribute 'lock'", "with its `self.`"),
        # What a callback counts is not what it says.
        (
            {"parts = self.parts\n": "parts = 5\n"},
            "busy for a while: the reports up to",
            "what the callback has counted",
        ),
        (
            parts(
                "self.parts += 1",
                f"now = round(10 * rospy.get_time())\nparts = now - self.told\nself.told = now\n{SAY_PARTS}",
                "self.told = round(10 * rospy.get_time())",
            ),
            "but the parts were counted 14 times",
            "a tick that is lost counts no part",
        ),
        # Read and written within one expression.
        (parts('setattr(self, "parts", self.parts + 1)', TAKE_PARTS), "take turns", "one lock"),
        (parts('self.__dict__.update(parts=self.__dict__["parts"] + 1)', TAKE_PARTS), "take turns", "one lock"),
        (
            parts('(lambda: setattr(self, "parts", 1 + self.__dict__.get("parts")))()', TAKE_PARTS),
            "take turns",
            "one lock",
        ),
    ],
    "stop-the-motor": [
        (
            {**HOOKED, HOOK: ""},
            "Ctrl-C while the loop sleeps: nothing stops the motor",
            "`rospy.on_shutdown(function)`",
        ),
        (
            {**HOOKED, ASKS: DRIVES},
            "stopped at 2.03 s, and driven again at 2.13 s",
            "Ask `rospy.is_shutdown()` before you drive",
        ),
        (
            {**HOOKED, HOOK: "", PASS: PASS + "\n    motor.drive(0.0)\n"},
            "The sensor fails: nothing stops the motor",
            "on_shutdown",
        ),
        (
            {**HOOKED, HOOK: "    rospy.on_shutdown(motor.drive(0.0))\n"},
            "shutdown hook [None] must be a function",
            "on_shutdown",
        ),
        (
            {**HOOKED, HOOK: "    rospy.on_shutdown(motor.drive)\n"},
            "shutdown hook stopped with `TypeError",
            "is called without arguments",
        ),
        (
            {
                **HOOKED,
                WHILE + PASS: "    def drive(event):\n        motor.drive(read_sensor())\n"
                "    rospy.Timer(rospy.Duration(0.1), drive)\n    rospy.spin()\n",
            },
            "The sensor fails at 1.06 s: the motor was not stopped before 5 s",
            "Ask `rospy.is_shutdown()`",
        ),
        (
            {**HOOKED, "        rate.sleep()": "        rate.sleep()\n        motor.drive(0.0)"},
            "up to then the motor was stopped at 0.1 s",
            "as before",
        ),
        ({**HOOKED, WHILE: "    while True:\n"}, "did not end at Ctrl-C", "on_shutdown"),
        (
            {
                **HOOKED,
                "        speed = read_sensor()\n": "        try:\n            speed = read_sensor()\n"
                "        except RuntimeError:\n            continue\n",
            },
            "The sensor fails at 1.06 s: the motor was not stopped",
            "that is caught",
        ),
        ({**HOOKED, "        rate.sleep()": ""}, "up to then the motor was told a speed", "drive the motor as before"),
        (
            {**HOOKED, HOOK: "    rospy.on_shutdown(lambda: motor.drive(0.1))\n"},
            "nothing stops the motor",
            "on_shutdown",
        ),
    ],
    "missing-ticks": [
        ({MISSING: "missing = lateness.to_sec()"}, "printed `missing = 1.4`, but 3 were missing", WHOLE),
        (
            {MISSING: "missing = round(lateness.to_sec() / 0.4)"},
            "printed `missing = 1`, but 0 were",
            "How many whole periods",
        ),
        ({"event.current_expected": "event.last_real"}, "stopped in line 11: `TypeError", "how late this call is"),
        (
            {'"[SPINNER PY NODE] missing = "': '"missing: "'},
            "no line with `missing = ` was printed",
            "how late this call",
        ),
        (
            {MISSING: "missing = int(lateness.to_sec() > 0.4)"},
            "printed `missing = 1`, but 3 were missing",
            "How many whole",
        ),
        (
            {MISSING: "missing = lateness"},
            "printed `missing = 1400000000`, but 3 were missing",
            "How many whole periods",
        ),
        (
            {MISSING: "missing = int(lateness.to_sec() / 0.5)"},
            "printed `missing = 2`, but 3 were missing",
            "How many whole",
        ),
        ({MISSING: "missing = 'none'"}, "printed `missing = none`, but 0 were missing", WHOLE),
        (
            {"            rospy.sleep(self.blocks_for)": "            pass"},
            "callbacks printed 12 lines",
            "how late this call",
        ),
        (
            {MISSING: "missing = int(lateness.to_sec() / 0.4)\n        if not missing: return"},
            "no line with `missing = `",
            "how late",
        ),
    ],
    "name-the-fault": [
        ({'log_1 = "B"': 'log_1 = "A"'}, "`log_1`: it is not A", "1 divided by what was asked for"),
        ({'log_1 = "B"': 'log_1 = "D"'}, "`log_1`: it is not D", "its first call after one period"),
        ({'log_3 = "D"': 'log_3 = "B"'}, "`log_3`: it is not B", "makes its first pass immediately"),
        ({'log_2 = "E"': 'log_2 = "F"'}, "`log_2`: it is not F", "nothing of the node goes on"),
        ({'log_3 = "D"': 'log_3 = "C"'}, "`log_3`: it is not C", "a period apart again"),
        ({'log_4 = "C"': 'log_4 = "E"'}, "`log_4`: it is not E", "a traceback would name a thread"),
        ({'log_4 = "C"': 'log_4 = "G"'}, "`log_4`: it is not G", "each number would be printed once"),
        ({'log_4 = "C"': 'log_4 = "C frequency"'}, "one of the letters A to G, not", 'Write it as `"A"`'),
        ({'log_4 = "C"': 'log_4 = "H"'}, "one of the letters A to G, not `'H'`", 'Write it as `"A"`'),
        ({'log_4 = "C"': "class Mine(str):\n    pass\nlog_4 = Mine('C')"}, "not `Mine`", 'Write it as `"A"`'),
        ({'log_4 = "C"': "log_4 = 3"}, "one of the letters A to G, not `3`", 'Write it as `"A"`'),
        ({'log_4 = "C"': "log_4 = C"}, "NameError: name 'C' is not defined", "A letter is a text."),
        ({'log_4 = "C"': ""}, "`log_4`: there is no answer yet", "Look at the first tick"),
    ],
    "what-is-heard": [
        (times(PLAIN_HEARD, 1, 2, 3), "Without `latch`: not 1, 2, 3", "is not connected yet"),
        (times(LATCHED_HEARD, 2, 3, 4), "With `latch`: not 2, 3, 4", "keeps its last message for whoever"),
        (times(THREE, 1, 2, 3), "Three in a row: not 1, 2, 3", "keeps one message only, the last"),
        (times(THREE, 1), "Three in a row: not 1.", "not the first"),
        (times(THREE), "Three in a row: not nothing at all", "keeps its last message for whoever"),
        (times(SLOW_HEARD, 0, 1, 2), "The slow callback: not 0, 1, 2", "happens without a `queue_size`"),
        (times(SLOW_HEARD, 0, 4, 8), "The slow callback: not 0, 4, 8", "does not wait for the next message"),
        (times(SLOW_HEARD, 0, 1, 4), "The slow callback: not 0, 1, 4", "is replaced by each newer one"),
        (times(SLOW_HEARD, 0, 3, 7), "the third of these counters is not 7", "Only one message can wait"),
        (times(PLAIN_HEARD, 2, 3), "3 counters are asked for, not 2", "Is the subscriber connected"),
        ({PLAIN_HEARD: "without_latch = 2"}, "a list of counters, not a value of type `int`", "`[1, 2, 3]`"),
        ({THREE: ""}, "Three in a row: there is no prediction yet", "Give `three_at_once` a list of counters"),
    ],
    "publish-the-counter": [
        (
            {f"        {PUBLISH}\n": ""},
            "on `/counter`: the node published nothing",
            "There is a publisher, but nothing publishes with it.",
        ),
        (IN_CALLBACK, "The listener: where counter 1 was due, counter 2 came", "Make it once, before the timer"),
        (
            {PUBLISHER: PUBLISHER.replace('"counter"', '"count"')},
            "it was published on `/count`",
            "The publisher uses the listener's topic, letter by letter:",
        ),
        (
            {PUBLISHER: PUBLISHER.replace('"counter"', '"~counter"')},
            "on `/publisher_py_node/counter`",
            "The publisher uses the listener's topic, letter by letter:",
        ),
        (
            {PUBLISHER: PUBLISHER.replace("UInt32", "Int32"), "import UInt32": "import Int32, UInt32"},
            "are of the type std_msgs/Int32",
            "have to name the same type",
        ),
        (
            {"Duration(0.2)": "Duration(5)"},
            "nothing was published on `/counter`",
            "Five times a second is once in 1 / 5 s.",
        ),
        (
            {"Duration(0.2)": "Duration(0.5)"},
            "On `/counter`: counter 1 came at 0.5 s, not at 0.2 s",
            "Five times a second is once in 1 / 5 s.",
        ),
        (
            {"        self.counter += 1\n": "", PUBLISH: f"{PUBLISH}\n        self.counter += 1"},
            "where counter 1 was due, counter 0 came",
            "The first counter is 1:",
        ),
        (
            {"publish(self.counter)": "publish(str(self.counter))"},
            "timer stopped in line 21:",
            "A field of a message takes values of its own type only.",
        ),
        (
            {"publish(self.counter)": "publish()"},
            "on `/counter`: each message holds 0, not a counter.",
            "A new message holds 0.",
        ),
        (
            {PUBLISHER: PUBLISHER.replace("UInt32, ", "")},
            "missing 1 required positional",
            '`rospy.Publisher("topic", UInt32, queue_size=10)`:',
        ),
        ({"self.publisher.": "self.pub."}, "has no attribute 'pub'", "with its `self.`"),
        (
            {PUBLISH: f"{PUBLISH}\n        {PUBLISH}"},
            "On `/counter`: where counter 2 was due, counter 1 came",
            "A counter comes more than once:",
        ),
        (
            {"        rospy.Subscriber": "        pass  # "},
            "The listener: no counter",
            "Nothing subscribes to `/counter` any more.",
        ),
    ],
    "late-subscriber": [
        ({LATCHES: ""}, "With `_subscribes_at:=1.0`: the goal did not arrive", "has a parameter `latch`"),
        ({LATCHES: "", "queue_size=10": "queue_size=1000"}, "the goal did not arrive", "has a parameter `latch`"),
        (
            planner("rospy.sleep(1.2)\nself.publisher.publish(7)"),
            "With `_subscribes_at:=2.5`: the goal did not",
            "latch",
        ),
        (
            planner("rospy.Timer(rospy.Duration(0.2), lambda event: self.publisher.publish(7))"),
            "With `_subscribes_at:=1.0`: the goal arrived 15 times",
            "Publish once, with a publisher that keeps",
        ),
        (
            planner("rospy.Timer(rospy.Duration(3), lambda event: self.publisher.publish(7), oneshot=True)"),
            "With `_subscribes_at:=1.0`: the goal arrived only at 3 s",
            "has a parameter `latch`",
        ),
        ({GOAL: GOAL.replace("7", "8")}, "the goal 8 arrived, not 7", "The goal is 7."),
        ({GOAL: ""}, "the goal did not arrive", "The planner publishes nothing on `/goal`."),
        (
            {LATCHES: "", '"goal", UInt32, self.goalCallback': '"goal", UInt32, self.goalCallback, latch=True'},
            "unexpected keyword argument 'latch'",
            "latch",
        ),
        ({GOAL: GOAL + "\n        self.publisher.unregister()"}, "the goal did not arrive", "has a parameter `latch`"),
        ({LATCHES: "latch=true, "}, "name 'true' is not defined", "In Python this is written `True`."),
        ({DO_SPIN: ""}, "the goal did not arrive", "The node ended by itself"),
        ({GOAL: f"{GOAL}\n        self.publisher.publish(0)"}, "the goal 0 arrived, not 7", "The goal is 7."),
    ],
    "newest-position": [
        (
            {SIZE: ")", "str(message.data)": "str(sensor.position)"},
            "printed position 4, but the message that it got held 2",
            "in another process",
        ),
        (
            {SIZE: ")"},
            "at 0.43 s the controller steered by position 2, which was 0.23 s old",
            "how many messages may wait there",
        ),
        ({SIZE: ")", "queue_size=10": "queue_size=1"}, "steered by position 2", "has a queue, too"),
        ({NEWEST: "self.positionCallback, queue_size=2)"}, "A newer one had arrived", "has a queue, too"),
        ({NEWEST: "self.positionCallback, queue_size=10)"}, "A newer one had arrived", "has a queue, too"),
        ({NEWEST: "self.positionCallback, queue_size=0)"}, "queue size may not be set to zero", "has a queue, too"),
        ({NEWEST: 'self.positionCallback, queue_size="1")'}, "queue size must be an integer", "has a queue, too"),
        ({"rospy.sleep(0.33)": "rospy.sleep(0.05)"}, "less than 0.33 s after the last time", "takes 0.33 s"),
        ({"Duration(0.1)": "Duration(0.4)"}, "the sensor published 25 positions", "The sensor should stay as it is."),
        (
            {'position = " + str(message.data)': 'position = " + str(message)'},
            "is not a position that",
            "A message is not yet its number:",
        ),
        (
            {"        rospy.sleep(0.33)": "        raise RuntimeError\n        rospy.sleep(0.33)"},
            "RuntimeError",
            "has a queue, too",
        ),
        (
            {"        rospy.Subscriber": "        pass  # "},
            "the controller: nothing subscribes to `/position`.",
            "The subscription uses the publisher's topic, letter by letter",
        ),
        (
            {NEWEST: "self.positionCallback(), queue_size=1)"},
            "missing 1 required positional",
            "Pass the function on without calling it:",
        ),
        (
            {"rospy.sleep(0.33)": "rospy.sleep(0.6)"},
            "the controller steered 17 times",
            "From one step to the next it took up to 0.6 s.",
        ),
    ],
    "rostopic-hz": [
        ({'"C"': '"A"'}, "`report_1`: it is not A", "`min` and `max` equal to the period"),
        ({'"C"': '"E"'}, "`report_1`: it is not E", "too low from the start"),
        ({'"D"': '"A"'}, "`report_2`: it is not A", "equal to the period"),
        ({'"D"': '"C"'}, "`report_2`: it is not C", "right at first"),
        ({'"E"': '"C"'}, "`report_3`: it is not C", "right at first"),
        ({'"B"': '"D"'}, "`report_4`: it is not D", "`min` 0"),
        ({'"E"': '"B"'}, "`report_3`: it is not B", "twice as many messages"),
        ({'"B"': '"F"'}, "one of the letters A to E, not `'F'`", 'Write it as `"A"`'),
        ({'"B"': "4"}, "one of the letters A to E, not `4`", 'Write it as `"A"`'),
        ({'report_4 = "B"': ""}, "`report_4`: there is no answer yet", "Compare the average"),
    ],
}

RIGHT |= answers_ros2.RIGHT
WRONG |= answers_ros2.WRONG
