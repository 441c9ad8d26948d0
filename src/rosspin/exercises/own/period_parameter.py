"""A parameter can be read without being declared: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import plain, say, say_error
from ..observed import ObservedRun

TITLE = "Take the period from a parameter"
TEXT = """
**You need**: the [tutorial on ROS 2](../docs/ros2/tutorial.rst), [the timer node in ROS 2](ros2-timer.md) and the
how-to [Set the frequency](../docs/how-to/frequency-from-parameter.rst).

Make the period a parameter called `period`, in seconds, with the default 0.5:

- With `--ros-args -p period:=0.1`, the node ticks ten times a second.
- With a period that is not above 0, such as `-p period:=-1.0`, the node does not tick. It logs an error that names the
  period, and exits with a non-zero status and without a traceback.
"""
REVEALS = "A parameter can be read without being declared. A timer refuses a period of 0."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class SpinnerPyNode(Node):
    def __init__(self):
        super().__init__("spinner_py_node")
        self.counter = 0
        period = 0.5
        self.create_timer(period, self.timer_callback)

    def timer_callback(self):
        self.counter += 1
        self.get_logger().info("[SPINNER PY NODE] counter = " + str(self.counter))


def main():
    rclpy.init()
    spinner_py_node = SpinnerPyNode()
    try:
        rclpy.spin(spinner_py_node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
"""

NODE_CPP = """
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"

using namespace std::chrono_literals;

class SpinnerCppNode : public rclcpp::Node
{
public:
  SpinnerCppNode() : Node("spinner_cpp_node")
  {
    double period = 0.5;
    timer_ = create_wall_timer(
        std::chrono::duration<double>(period), [this] { timerCallback(); });
  }

private:
  void timerCallback()
  {
    counter_++;
    RCLCPP_INFO_STREAM(get_logger(), "[SPINNER CPP NODE] counter = " << counter_);
  }

  unsigned int counter_ = 0;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<SpinnerCppNode>());
  return 0;
}
"""

HINTS = [
    '`self.declare_parameter("name", 0.5)` declares a parameter with its default, and returns it. '
    "Its `.value` is what the command line says, or the default.",
    "What does the timer do with a period of 0.0, and what with -1.0? Check the period before you make the timer.",
    "`self.get_logger().error(...)` logs an error. `sys.exit(1)` ends a program with status 1 and "
    "without a traceback, also from `__init__`.",
]
HINTS_CPP = [
    '`declare_parameter("name", 0.5)` declares a parameter with its default, and returns what the command line says, '
    "or the default.",
    "What does the timer do with a period of 0.0, and what with -1.0? Check the period before you make the timer.",
    "`RCLCPP_ERROR` logs an error. `std::exit(1)` ends a program with status 1, also from a constructor.",
]
_IN_SECONDS = 'The parameter is called "period". Is it what the timer is given, in seconds?'
_DEFAULT = "Without the parameter the period is its default, 0.5 s. Is it what the timer is given, in seconds?"
HINT = "`self.declare_parameter(name, default).value` is a parameter's value. Look at it before you make the timer."
HINT_CPP = "`declare_parameter(name, default)` returns the value of a parameter. Look at it before you make the timer."


def _refuses(run: ObservedRun, when: str) -> Finding:
    """Whether a node has refused a parameter in words, with a status other than 0 and without a traceback."""
    look = "Look at the period before you make the timer: write an error line, and end with status 1."
    if counters := run.counters():
        if any(timer.is_endless for timer in run.timers):
            endless = f"A timer takes a period of 0, and then calls back without a pause. {look}"
            return Finding(False, f"{when}: the node ticked anyway, without a pause.", endless)
        often = "once" if len(counters) == 1 else f"{len(counters)} times"
        other = "The node should refuse such a period, not take another one in its place."
        return Finding(False, f"{when}: the node ticked anyway, {often} in {say(run.seconds)}.", f"{other} {look}")
    if run.errors:
        return Finding(False, f"{when}: the {say_error(run.errors[-1])}", look)
    if run.interrupted:
        return Finding(False, f"{when}: the node kept running without ticking.", look)
    if not run.status:
        ends = "Whatever started the node learns from its status whether all is well: end it with status 1."
        return Finding(False, f"{when}: the node ended with status 0, as if all were well.", ends)
    said = [line.text.strip() for line in run.printed if "period" in line.text.lower()]
    if not said:
        return Finding(False, f"{when}: no line says that the period is wrong.", look)
    if not any(line.startswith(("[ERROR]", "[FATAL]")) for line in said):
        return Finding(False, f"{when}: the node did not log `{plain(said[0])}` as an error.", look)
    return Finding(True, f"{when}: the node said `{plain(said[0])}`, and ended with status {run.status}.")


check = by.every(
    by.run(2.0, by.ticks(0.5, hint=_DEFAULT), when="Without the parameter"),
    by.until_wrong(
        by.run(1.0, by.ticks(0.1, hint=_IN_SECONDS), by.declares("period"), given="period:=0.1"),
        by.run(5.0, by.ticks(2.0, hint=_IN_SECONDS), given="period:=2.0"),
        by.every(
            by.ending(1.0, _refuses, given="period:=0.0"),
            by.ending(1.0, _refuses, given="period:=-1.0"),
        ),
    ),
)

SOLUTION = {
    "import rclpy\n": "import sys\n\nimport rclpy\n",
    "        period = 0.5\n": '        period = self.declare_parameter("period", 0.5).value\n'
    "        if not period > 0:\n"
    '            self.get_logger().error("the period has to be above 0 s, not " + str(period))\n'
    "            sys.exit(1)\n",
}
AFTER = """
rclpy itself refuses anything that is not a float: even `-p period:=2` raises an `InvalidParameterTypeException`.
"""

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

RIGHT = [
    {PERIOD: '        self.declare_parameter("period", 0.5)\n        period = self.get_parameter("period").value\n'},
    {
        PERIOD: '        self.declare_parameter("period", 0.5)\n'
        '        period = self.get_parameter("period").get_parameter_value().double_value\n'
    },
    # It looks in main, and returns a status.
    {
        REFUSES: '        if period <= 0:\n            raise ValueError("a period of " + str(period) + " s")\n',
        "    spinner_py_node = SpinnerPyNode()\n": "    try:\n        spinner_py_node = SpinnerPyNode()\n"
        "    except ValueError as error:\n        rclpy.logging.get_logger('spinner_py_node').fatal(str(error))\n"
        "        return 2\n",
        "import rclpy\n": "import rclpy\nimport rclpy.logging\n",
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
        'period = node.declare_parameter("period", 0.5).value\n'
        'if period <= 0: sys.exit(node.get_logger().error("bad period") and 1)\n'
        "node.create_timer(period, callback)",
    ),
    {REFUSES: REFUSES.replace("sys.exit(1)", "rclpy.shutdown()\n            sys.exit(3)")},
]
WRONG = [
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
        "the period is its default, 0.5 s",
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
        "end with status 1",
    ),
    (
        {REFUSES: "        period = max(period, 0.01)\n"},
        "With `period:=0.0`: the node ticked anyway, 100 times in 1 s",
        "not take another one in its place",
    ),
    ({REFUSES: REFUSES.replace(".error(", ".info(")}, "did not log `[INFO]", "write an error line"),
    ({REFUSES: REFUSES.replace(".error(", ".warning(")}, "did not log `[WARN]", "write an error line"),
    ({REFUSES: REFUSES.replace("self.get_logger().error(", "print(")}, "did not log `the period has", "an error line"),
    (
        {REFUSES: '        if period <= 0:\n            raise SystemExit("period must be above 0")\n'},
        "did not log `period must be above 0` as an error",
        "write an error line",
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
        "end with status 1",
    ),
    (
        {REFUSES: REFUSES.replace("sys.exit(1)", "period = 0.5")},
        "the node ticked anyway, 2 times in 1 s",
        "Look at the",
    ),
    (
        {PERIOD: PERIOD.replace("0.5", "1")},
        "Started with `--ros-args -p period:=0.1`",
        "the period is its default, 0.5 s",
    ),
]

CHECKS_CPP = (
    "    if (period <= 0.0)\n    {\n"
    '      RCLCPP_ERROR_STREAM(get_logger(), "The period has to be above 0 s, not " << period);\n'
    "      std::exit(1);\n    }\n"
)
READS_CPP = '    double period = declare_parameter("period", 0.5);\n'

SOLUTION_CPP = {"    double period = 0.5;\n": READS_CPP + CHECKS_CPP}

RIGHT_CPP = [
    {READS_CPP: '    declare_parameter("period", 0.5);\n    double period = get_parameter("period").as_double();\n'},
    {READS_CPP: '    auto period = declare_parameter<double>("period", 0.5);\n'},
    {
        READS_CPP: '    double period = 0.0;\n    declare_parameter("period", 0.5);\n'
        '    get_parameter("period", period);\n'
    },
    {"std::exit(1);": "rclcpp::shutdown();\n      std::exit(2);"},
    {"period <= 0.0": "!(period > 1e-3)"},
]
WRONG_CPP = [
    (
        {CHECKS_CPP: ""},
        "With `period:=0.0`: the node ticked anyway",
        "A timer takes a period of 0, and then calls back without a",
    ),
    (
        {READS_CPP: "    double period = 0.5;\n"},
        "With `period:=0.1`: counter 1 came at 0.5 s",
        'The parameter is called "period". Is it what the timer is',
    ),
    (
        {'"period", 0.5': '"Period", 0.5'},
        "With `period:=0.1`: counter 1 came at 0.5 s",
        'The parameter is called "period"',
    ),
    (
        {"period <= 0.0": "period < 0.0"},
        "With `period:=0.0`: the node ticked anyway",
        "A timer takes a period of 0, and then calls back without a",
    ),
    (
        {"std::exit(1);": "std::exit(0);"},
        "the node ended with status 0, as if all were well",
        "Whatever started the node learns from its status whether all is",
    ),
    ({"std::exit(1);": "return;"}, "the node kept running without ticking", "Look at the period before"),
    (
        {"std::exit(1);": 'throw std::invalid_argument("period");'},
        "With `period:=0.0`: the node stopped with `terminate",
        "Look at the period before you make the timer: write an error",
    ),
    ({"The period has": "It has"}, "no line says that the period is wrong", "Look at the period before"),
    (
        {"duration<double>(period)": "duration<double>(1 / period)"},
        "Without the parameter: counter 1 came at 2 s",
        "the period is its default, 0.5 s",
    ),
    (
        {"0.5)": "1)"},
        "Without the parameter: counter 1 came at 1 s, not at 0.5 s.",
        "the period is its default, 0.5 s",
    ),
    (
        {READS_CPP: '    declare_parameter("period", 0.5);\n    double period = get_parameter("period");\n'},
        "does not compile",
        "Nothing ran. Begin with the compiler's first error: others may",
    ),
    (
        {READS_CPP: '    double period = get_parameter("period").as_double();\n'},
        "The node stopped with `terminate called after throwing an",
        "What threw this says in its own words what was wrong, and",
    ),
]
