"""Ctrl-C makes `rclpy.spin` return: a belief that this reveals."""

from __future__ import annotations

from functools import partial

from .. import judges as by
from ..feedback import Finding
from ..observed import ObservedRun

TITLE = "End without a traceback"
TEXT = """
**You need**: the [tutorial on ROS 2](../docs/ros2/tutorial.rst), and what
[How timing works in ROS 2](../docs/ros2/how-timing-works.rst) says of how a node ends.

At Ctrl-C this node ends with a traceback, and its motor continues at the last speed. Repair the node so that

- Ctrl-C and SIGTERM end it with status 0 and without a traceback, whatever it is doing,
- `motor.drive(0.0)` stops the motor, however the node ends, and
- an error, such as a sensor that fails, still ends the node with its traceback.
"""
REVEALS = "Ctrl-C makes `rclpy.spin` return. Code after `spin` always runs."

NODE = """
import time

import rclpy
from rclpy.node import Node


class Motor:
    def drive(self, speed):
        print("[MOTOR] speed = " + str(speed), flush=True)


class DriverPyNode(Node):
    def __init__(self, motor):
        super().__init__("driver_py_node")
        self.motor = motor
        self.fails_at = self.declare_parameter("fails_at", 0).value
        self.readings = 0
        self.create_timer(0.1, self.timer_callback)

    def timer_callback(self):
        speed = self.read_sensor()
        self.motor.drive(speed)

    def read_sensor(self):
        self.readings += 1
        time.sleep(0.06)
        if self.readings == self.fails_at:
            raise RuntimeError("no sensor")
        return 1.0


def main():
    rclpy.init()
    motor = Motor()
    driver_py_node = DriverPyNode(motor)
    rclpy.spin(driver_py_node)
    motor.drive(0.0)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
"""

HINTS = [
    "The last line of the traceback names the exception that came out of `spin`. So the line after `spin` never ran.",
    "Put `try:`, `except ...:` and `finally:` around `spin`. SIGTERM raises another exception than "
    "Ctrl-C: `ExternalShutdownException`, from `rclpy.executors`.",
    "Code in `finally` always runs, even if the sensor fails. Catch no more than the two "
    "exceptions, and call `rclpy.try_shutdown()`: after a signal, `rclpy.shutdown()` fails.",
]
_SWALLOWED = "Catch what a signal raises, and nothing else: an error should end the node with its traceback."
_drives_until_2 = partial(
    by.drives_until,
    again="Stop the motor last, when no callback can run any more: after `spin`, in a `finally`.",
    late=_SWALLOWED,
)
HINT = (
    "`try:` around `spin`, `except (KeyboardInterrupt, ExternalShutdownException): pass`, and in a `finally:` "
    "what must always be done."
)


def _fails(run: ObservedRun, when: str) -> Finding:
    """Whether an error has ended the node with a status other than 0."""
    if run.status and not run.errors:
        text = f"{when}: the node ended with status {run.status}, but without a traceback."
        return Finding(False, text, _SWALLOWED)
    if run.status:
        return Finding(True, f"{when}: the node ended with status {run.status}.")
    went_on = "continued" if run.interrupted else "ended with status 0, as if all were well"
    return Finding(False, f"{when}: the node {went_on}.", _SWALLOWED)


check = by.every(
    by.run(2.08, _drives_until_2(2.08), by.ends_well, when="Ctrl-C while the node waits"),
    by.run(2.03, _drives_until_2(2.03), by.ends_well, when="Ctrl-C while the sensor is read"),
    by.ending(5.08, _drives_until_2(2.08), by.ends_at_sigterm(2.08), when="SIGTERM", terminated_at=2.08),
    by.ending(5.0, _drives_until_2(1.06), _fails, given="fails_at:=10", when="The sensor fails"),
)

SOLUTION = {
    "import rclpy\n": "import rclpy\nfrom rclpy.executors import ExternalShutdownException\n",
    "    rclpy.spin(driver_py_node)\n    motor.drive(0.0)\n    rclpy.shutdown()\n": "    try:\n"
    "        rclpy.spin(driver_py_node)\n"
    "    except (KeyboardInterrupt, ExternalShutdownException):\n"
    "        pass\n"
    "    finally:\n"
    "        motor.drive(0.0)\n"
    "        rclpy.try_shutdown()\n",
}
AFTER = """
A motor that is stopped by a message needs more: after a signal the node cannot publish, unless it was started with
`rclpy.init(signal_handler_options=SignalHandlerOptions.NO)`.
"""

CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
DRIVE_SPIN = "        rclpy.spin(driver_py_node)\n"
STOPS = "        motor.drive(0.0)\n"
DRIVE_END = f"    finally:\n{STOPS}        rclpy.try_shutdown()\n"
DRIVES = "        self.motor.drive(speed)\n"

RIGHT = [
    {
        CAUGHT: "    except (ExternalShutdownException, KeyboardInterrupt):\n        pass\n",
    },
    {
        CAUGHT: "    except KeyboardInterrupt:\n        pass\n    except ExternalShutdownException:\n        pass\n",
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
]
WRONG = [
    (
        {"    finally:\n": "    except RuntimeError:\n        raise SystemExit(1)\n    finally:\n"},
        "The sensor fails: the node ended with status 1, but without a traceback",
        "nothing else",
    ),
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
        "and nothing else: an error should",
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
]
