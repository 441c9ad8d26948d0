"""After a shutdown hook nothing else of the node runs: a belief that this reveals."""

from __future__ import annotations

from functools import partial

from .. import judges as by

TITLE = "Stop the motor"
TEXT = """
**You need**: [the Rate node](rate.md), and what the [tutorial](../docs/tutorial.rst) says about `rospy.on_shutdown`.

This motor keeps its last speed, even after the node has ended. Whatever ends the node, the last speed must be 0: Ctrl-C
at any point of the loop, or a sensor that fails, as with `_fails_at:=1.0`. An exception may still end the node.
"""
REVEALS = "After a shutdown hook nothing else of the node runs. A node ends by Ctrl-C only."

NODE = '''
import rospy


class Motor:
    """Keeps its last speed until it is told another one."""

    def drive(self, speed):
        rospy.loginfo("[MOTOR] speed = " + str(speed))


def read_sensor():
    rospy.sleep(0.06)  # the sensor takes its time
    if rospy.get_time() > rospy.get_param("~fails_at", 60.0):
        raise RuntimeError("no sensor")
    return 0.5


if __name__ == '__main__':
    rospy.init_node("spinner_py_node")
    motor = Motor()
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        speed = read_sensor()
        motor.drive(speed)
        rate.sleep()
'''

HINTS = [
    "`rospy.on_shutdown(function)` has a function called at the end. What should it do?",
    "If Ctrl-C comes while the sensor is read, the hook is called, and the pass continues. What is its next line?",
    "Stop the motor after the loop, in a `finally`. (To ask `rospy.is_shutdown()` before driving leaves a small gap.)",
]
HINT = (
    "Ctrl-C ends the loop without an exception, a sensor that fails with one. `finally` sees both, and so does a hook, "
    "`rospy.on_shutdown(function)`."
)

_drives_until = partial(
    by.drives_until,
    again="A hook runs in the middle of a pass, which then continues. Ask `rospy.is_shutdown()` before you drive, or "
    "stop the motor after the loop, in a `finally`.",
    late="An exception that is caught, or that ends a timer alone, does not end the node: no hook is called.",
)

check = by.every(
    by.run(2.08, _drives_until(2.08), when="Ctrl-C while the loop sleeps"),
    by.run(2.03, _drives_until(2.03), when="Ctrl-C while the sensor is read"),
    by.run(5.0, _drives_until(1.06), given="_fails_at:=1.0", when="The sensor fails", allowed="no sensor"),
)

SOLUTION = {
    (
        "    while not rospy.is_shutdown():\n"
        "        speed = read_sensor()\n"
        "        motor.drive(speed)\n"
        "        rate.sleep()\n"
    ): (
        "    try:\n"
        "        while not rospy.is_shutdown():\n"
        "            speed = read_sensor()\n"
        "            motor.drive(speed)\n"
        "            rate.sleep()\n"
        "    finally:\n"
        "        motor.drive(0.0)\n"
    )
}
AFTER = """
A hook alone is not enough: if Ctrl-C comes just before `motor.drive(speed)`, the hook stops the motor, and the pass
starts it again.
"""

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
HOOKED = {FINALLY: HOOK + RATE + WHILE + PASS}

RIGHT = [
    # Both: the pass that drives after the hook ends in the finally.
    {RATE: HOOK + RATE},
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
]
WRONG = [
    (
        {"    finally:\n": "    except Exception:\n"},
        "Ctrl-C while the loop sleeps: nothing stops the motor",
        "Ctrl-C ends the loop without an exception",
    ),
    (
        {"finally:\n": "finally:\n        rospy.sleep(1.0)\n"},
        "the motor was not stopped before 3.18 s",
        "what does the node wait for?",
    ),
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
]
