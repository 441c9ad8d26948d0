"""The same topic and the same type are enough to connect: a belief that this reveals."""

from __future__ import annotations

from .. import judges as by
from ..feedback import Finding
from ..judging import plain, say
from ..observed import ObservedRun, Printed

TITLE = "Make both ends match"
TEXT = """
**You need**: [publish and subscribe in ROS 2](../docs/ros2/publish.rst) and [its notebook](ros2-publish.md).

The sensor of this node publishes a position every 0.5 s, but the controller hears none. Repair the controller, not the
sensor: each position should be printed as soon as it is published.
"""
REVEALS = "The same topic and the same type are enough to connect."

NODE = """
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import UInt32


class RobotPyNode(Node):
    def __init__(self):
        super().__init__("robot_py_node")
        self.position = 0

        # The sensor, which should stay as it is
        self.publisher = self.create_publisher(UInt32, "position", qos_profile_sensor_data)
        self.create_timer(0.5, self.sensor_callback)

        # The controller
        self.create_subscription(UInt32, "position", self.position_callback, 10)

    def sensor_callback(self):
        self.position += 1
        self.publisher.publish(UInt32(data=self.position))

    def position_callback(self, message):
        self.get_logger().info("[CONTROLLER] position = " + str(message.data))


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

NODE_CPP = """
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

using namespace std::chrono_literals;

class RobotCppNode : public rclcpp::Node
{
public:
  RobotCppNode() : Node("robot_cpp_node")
  {
    // The sensor, which should stay as it is
    publisher_ = create_publisher<std_msgs::msg::UInt32>("position", rclcpp::SensorDataQoS());
    timer_ = create_wall_timer(500ms, [this] { sensorCallback(); });
    // The controller
    subscription_ = create_subscription<std_msgs::msg::UInt32>("position", 10,
        [this](const std_msgs::msg::UInt32& message) { positionCallback(message); });
  }

private:
  void sensorCallback()
  {
    position_.data++;
    publisher_->publish(position_);
  }

  void positionCallback(const std_msgs::msg::UInt32& message)
  {
    RCLCPP_INFO_STREAM(get_logger(), "[CONTROLLER] position = " << message.data);
  }

  std_msgs::msg::UInt32 position_;
  rclcpp::Publisher<std_msgs::msg::UInt32>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::UInt32>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<RobotCppNode>());
  return 0;
}
"""

HINTS = [
    "Run the cell and read the warnings. What does the last word of each name?",
    "A subscription with `10` asks for reliable messages. Does `qos_profile_sensor_data` offer them?",
    "If a publisher offers less than a subscription asks for, they do not connect. Ask for no more "
    "than the sensor offers.",
]
HINTS_CPP = [
    "Run the cell and read the warnings. What does the last word of each name?",
    "A subscription with `10` asks for reliable messages. Does `rclcpp::SensorDataQoS()` offer them?",
    HINTS[2],
]
HINT = "The warnings name the policy that does not match. The subscription asks for more than the sensor offers."
HINT_CPP = HINT


def _hears_all(run: ObservedRun, when: str) -> Finding:
    """Whether the controller hears each position immediately, one of which the sensor publishes each period.

    The subscription has to be connected to it, and no other endpoint may be left that is not.
    """
    due = by.grid(0.5, run.seconds)
    sent = [Printed(message.time, message.data) for message in run.sent if message.topic == "/position"]
    heard = run.values("CONTROLLER", "position")
    if sent and heard and sent[0].text == heard[0].text and heard[0].time - sent[0].time > by.CLOSE:
        text = f"The controller: position 1 came at {say(sent[0].time)}, and was printed only at {say(heard[0].time)}."
        return Finding(False, text, "What keeps its callback? Meanwhile nothing else is called, the sensor included.")
    published = by.on_time(sent, due, "The sensor", by.AS_IT_IS, "position")
    if not published.right:
        return published
    if wrong := by.sensor_of(run, "best_effort, volatile, depth 5") or by.unmatched(run):
        return wrong
    if any(line.timer for line in heard):
        return by.called_itself("The controller")
    if others := [line.text for line in heard if not line.heard]:
        text = f"The controller: position {plain(others[0])} was not printed by the callback of its subscription."
        return Finding(False, text, "The subscription calls its callback when a message has come. Leave that to it.")
    if (many := len(run.endpoints_of("/position", False))) > 1:
        text = f"The controller: it has {many} subscriptions to `/position`, and hears each message {many} times."
        return Finding(False, text, "Change the subscription that is there.")
    as_it_comes = "The subscription's callback should print `[CONTROLLER] position = ` and the number in the message."
    return by.on_time(heard, due, "The controller", as_it_comes, "position")


check = by.run(5.0, _hears_all)

SOLUTION = {"10": "qos_profile_sensor_data"}
AFTER = """
A publisher may offer more than a subscription asks for.
"""

SPIN = "        rclpy.spin(spinner_py_node)\n"
CAUGHT = "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n"
FINALLY = "    finally:\n        rclpy.try_shutdown()\n"
TRY = f"    try:\n{SPIN}{CAUGHT}{FINALLY}"
HEARS = "self.position_callback, qos_profile_sensor_data)"
RELIABLE = "The subscription asks for reliable messages"
STAYS = "The sensor should stay as it is"
IMPORTS_QOS = "from rclpy.qos import qos_profile_sensor_data"
BEST = "QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)"
IMPORTS_BEST = {IMPORTS_QOS: f"{IMPORTS_QOS}, QoSProfile, ReliabilityPolicy"}
BEGINS = "    def position_callback(self, message):\n"
CALLED_ITSELF = "        self.position_callback(UInt32(data=self.position))\n"
MAKES_SENSOR = 'self.create_publisher(UInt32, "position", qos_profile_sensor_data)'

RIGHT = [
    {HEARS: "self.position_callback, qos_profile_sensor_data, raw=False)"},
    {HEARS: f"self.position_callback, {BEST})", **IMPORTS_BEST},
    {HEARS: f"self.position_callback, qos_profile=({BEST}))", **IMPORTS_BEST},
    {
        HEARS: "self.position_callback, rclpy.qos.qos_profile_sensor_data)",
        IMPORTS_QOS: f"import rclpy.qos\n{IMPORTS_QOS}",
    },
    {TRY.replace("spinner", "robot"): "    rclpy.spin(robot_py_node)\n"},
]
WRONG = [
    (
        {HEARS: 'self.position_callback, "qos_profile_sensor_data")'},
        "Expected QoSProfile or int, but received <class 'str'>",
        "write its name without quotation marks",
    ),
    *(
        (
            {"import rclpy\n": "import time\nimport rclpy\n", BEGINS: f"{BEGINS}        time.sleep({seconds})\n"},
            f"position 1 came at 0.5 s, and was printed only at {0.5 + seconds:g} s",
            "What keeps its callback?",
        )
        for seconds in (0.1, 1)
    ),
    (
        {
            HEARS: "self.position_callback, QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, "
            "liveliness=LivelinessPolicy.MANUAL_BY_TOPIC))",
            IMPORTS_QOS: f"{IMPORTS_QOS}, LivelinessPolicy, QoSProfile, ReliabilityPolicy",
        },
        "best_effort, volatile, depth 5 does not match",
        "The warnings name the policy",
    ),
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
        "The subscription uses the publisher's topic, letter by letter",
    ),
    (
        {HEARS: f'{HEARS}\n        self.create_subscription(UInt32, "position", {HEARS}'},
        "The controller: it has 2 subscriptions to `/position`",
        "Change the subscription that is there.",
    ),
    (
        {HEARS: f"{HEARS}\n        self.position_callback(UInt32(data=0))"},
        "The controller: position 0 was not printed by the callback of its subscription",
        "Leave that to it.",
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
        "The subscription's callback should print `[CONTROLLER] position = `",
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
]

HEARS_CPP = '_subscription<std_msgs::msg::UInt32>("position", rclcpp::SensorDataQoS(),'
GIVEN_CPP = '_subscription<std_msgs::msg::UInt32>("position", 10,'
SENDS_CPP = "    publisher_->publish(position_);\n"

SOLUTION_CPP = {GIVEN_CPP: HEARS_CPP}

RIGHT_CPP = [
    {HEARS_CPP: HEARS_CPP.replace("rclcpp::SensorDataQoS()", "rclcpp::QoS(10).best_effort()")},
    {HEARS_CPP: HEARS_CPP.replace("rclcpp::SensorDataQoS()", "rclcpp::BestAvailableQoS()")},
    {
        HEARS_CPP: HEARS_CPP.replace(
            "rclcpp::SensorDataQoS()",
            "rclcpp::QoS(rclcpp::KeepLast(1)).reliability(rclcpp::ReliabilityPolicy::BestEffort)",
        )
    },
    {
        "[this](const std_msgs::msg::UInt32& message)": "[this](std_msgs::msg::UInt32::ConstSharedPtr given)",
        "positionCallback(message); }": "positionCallback(*given); }",
    },
]
WRONG_CPP = [
    (
        {HEARS_CPP: GIVEN_CPP},
        "the controller: a subscription with reliable, volatile, depth 10 does not match",
        RELIABLE,
    ),
    (
        {HEARS_CPP: GIVEN_CPP.replace("10", "1")},
        "the controller: a subscription with reliable, volatile, depth 1 does",
        RELIABLE,
    ),
    (
        {
            '"position", rclcpp::SensorDataQoS());': '"position", 10);',
            HEARS_CPP: GIVEN_CPP,
        },
        "the sensor: its publisher now has reliable, volatile, depth 10",
        STAYS,
    ),
    (
        {HEARS_CPP: HEARS_CPP.replace("SensorDataQoS()", "SensorDataQoS().transient_local()")},
        "best_effort, transient_local, depth 5 does not match",
        "The sensor keeps none",
    ),
    (
        {HEARS_CPP: GIVEN_CPP, SENDS_CPP: SENDS_CPP + "    positionCallback(position_);\n"},
        "a subscription with reliable, volatile, depth 10 does not match",
        RELIABLE,
    ),
    (
        {"{ positionCallback(message); }": "{}", SENDS_CPP: SENDS_CPP + "    positionCallback(position_);\n"},
        "The controller: its lines were printed in a call of a timer",
        "A topic carries the message",
    ),
    (
        {HEARS_CPP: HEARS_CPP.replace('"position"', '"positions"')},
        "the controller: nothing subscribes to `/position`: it subscribes to `/",
        "letter by letter",
    ),
    (
        {"    // The controller\n": "    positionCallback(position_);\n"},
        "The controller: position 0 was not printed by the callback of its subscription",
        "Leave that to it.",
    ),
    ({"500ms": "1s"}, "The sensor: position 1 came at 1 s, not at 0.5 s", STAYS),
    ({SENDS_CPP: ""}, "The sensor: no position was printed", STAYS),
    (
        {"    subscription_ = ": "    auto subscription_ = "},
        "The controller: no position was printed.",
        "The subscription's callback should print `[CONTROLLER] position",
    ),
]
