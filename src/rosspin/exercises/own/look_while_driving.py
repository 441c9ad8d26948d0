"""A long callback keeps all others of a single-threaded executor waiting, the one that steers too."""

from __future__ import annotations

from collections.abc import Iterator

from .. import Finding
from ..driving import commands, follows, is_rare, steady
from ..judging import Answer, say

TITLE = "Look while driving"
TEXT = """
The node now also looks at each picture of the camera for 0.3 s. Keep the vehicle on its line, without looking at fewer
pictures, or for a shorter time, and steer ten times a second, as before.
"""
REVEALS = "Callbacks run at the same time by themselves. More threads are enough, or a group is."

NODE = """
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, UInt32


class DriverPyNode(Node):
    def __init__(self):
        super().__init__("driver_py_node")
        self.offset = 0.0
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(Float32, "line", self.line_callback, 10)
        self.create_subscription(UInt32, "picture", self.picture_callback, 1)
        self.create_timer(0.1, self.timer_callback)

    def line_callback(self, message):
        self.offset = message.data

    def picture_callback(self, message):
        time.sleep(0.3)  # looks for people
        self.get_logger().info("[CAMERA] picture = " + str(message.data))

    def timer_callback(self):
        command = Twist()
        command.linear.x = 2.0
        command.angular.z = 8.0 * self.offset
        self.publisher.publish(command)


def main():
    rclpy.init()
    driver_py_node = DriverPyNode()
    try:
        rclpy.spin(driver_py_node)
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

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float32.hpp"
#include "std_msgs/msg/u_int32.hpp"

using namespace std::chrono_literals;

class DriverCppNode : public rclcpp::Node
{
public:
  DriverCppNode() : Node("driver_cpp_node")
  {
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    subscription_ = create_subscription<std_msgs::msg::Float32>("line", 10,
        [this](const std_msgs::msg::Float32& message) { lineCallback(message); });
    camera_ = create_subscription<std_msgs::msg::UInt32>("picture", 1,
        [this](const std_msgs::msg::UInt32& message) { pictureCallback(message); });
    timer_ = create_wall_timer(100ms, [this] { timerCallback(); });
  }

private:
  void lineCallback(const std_msgs::msg::Float32& message)
  {
    offset_ = message.data;
  }

  void pictureCallback(const std_msgs::msg::UInt32& message)
  {
    rclcpp::sleep_for(300ms);  // looks for people
    RCLCPP_INFO_STREAM(get_logger(), "[CAMERA] picture = " << message.data);
  }

  void timerCallback()
  {
    geometry_msgs::msg::Twist command;
    command.linear.x = 2.0;  // m/s
    command.angular.z = 8.0 * offset_;  // rad/s, to the left
    publisher_->publish(command);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr subscription_;
  rclcpp::Subscription<std_msgs::msg::UInt32>::SharedPtr camera_;
  rclcpp::TimerBase::SharedPtr timer_;
  double offset_ = 0.0;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<DriverCppNode>());
  rclcpp::shutdown();
  return 0;
}
"""

HINTS = [
    "Who could call the timer's callback while `picture_callback` looks for people?",
    "`rclpy.spin(node, MultiThreadedExecutor(2))` has two threads. Which callbacks may they call at the same time?",
    "Callbacks of one group wait for each other, and all are in the node's own group. Give one of them another: "
    "`callback_group=MutuallyExclusiveCallbackGroup()`.",
]
HINTS_CPP = [
    "Who could call the timer's callback while `pictureCallback` looks for people?",
    "A `rclcpp::executors::MultiThreadedExecutor` has several threads. Which callbacks may they call at the same time?",
    "Callbacks of one group wait for each other, and all are in the node's own group. Give one of them another, by the "
    "`callback_group` of its `rclcpp::SubscriptionOptions`.",
]

_WAITS = (
    "While a picture is looked at, nothing steers. With two threads, and a callback group of its own for "
    "what looks at it, the others continue."
)
_ONE_THREAD = (
    "While a picture is looked at, nothing steers: the executor that spins has one thread. A `MultiThreadedExecutor` "
    "has more, if it is the one that spins."
)
_ONE_GROUP = (
    "The executor has threads enough now, but callbacks of one group wait for each other. What looks at pictures needs "
    "a group of its own."
)
_SINGLE = "MultiThreadedExecutor is used with a single thread"
_OLD = (
    "The commands come often enough, but from an old offset: the line's callback has to wait while a picture is looked "
    "at. It is what looks at pictures that needs a group of its own."
)
_SLEEP = "More than one callback sleeps. Only the one that looks at pictures needs time."
_BLIND = "The vehicle's camera publishes on `picture`, and the node does not subscribe to it."
_LOOK = "Leave what looks at a picture as it is: 0.3 s for a picture, and then its log line."


def check(answer: Answer) -> Iterator[Finding]:
    """Whether the vehicle keeps to its line while pictures are looked at."""
    run = answer.run(8.0, beside=["vehicle"])
    hint = _SLEEP if len(run.loops) > 1 else _OLD
    if is_rare(run):
        hint = _WAITS if run.language == "cpp" else _ONE_GROUP if run.aside else _ONE_THREAD
        if any(_SINGLE in line.text for line in run.printed):
            hint = "The executor has one thread, as its warning says. With two, one can steer while the other looks."
    followed = follows(run, hint)
    yield followed
    if followed.right and len(commands(run)) < 72 and any(abs(timer.period - 0.1) < 1e-6 for timer in run.timers):
        text = f"{len(commands(run))} commands came in {say(run.seconds)}, where 80 are asked for."
        yield Finding(False, text, "The timer's callback still waits while a picture is looked at.")
    elif followed.right:
        yield from steady(run, 0.1)
    looked = [line for line in run.values("CAMERA", "picture") if line.time < run.seconds]
    numbers = [int(line.text) if line.text.isdecimal() and len(line.text) < 6 else 0 for line in looked]
    if len(looked) < 20:
        text = f"{len(looked)} pictures were looked at in {say(run.seconds)}, where 20 are the least."
        yield Finding(False, text, _LOOK if run.endpoints_of("/picture", False) else _BLIND)
        return
    # The vehicle takes a picture every 0.25 s.
    early = [line for line, number in zip(looked, numbers, strict=True) if line.time < 0.25 * number + 0.299]
    if early or 0 in numbers:
        line = early[0] if early else looked[numbers.index(0)]
        text = f"at {say(line.time)} a picture was done that had not been looked at for 0.3 s."
        yield Finding(False, text, _LOOK)
    else:
        yield Finding(True, f"{len(looked)} pictures were looked at.")


_IMPORTS = (
    "from rclpy.callback_groups import MutuallyExclusiveCallbackGroup\n"
    "from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor\n"
)
_THREADS = {
    "from rclpy.executors import ExternalShutdownException\n": _IMPORTS,
    "spin(driver_py_node)": "spin(driver_py_node, MultiThreadedExecutor(2))",
}
_LINE_ALONE = {"_callback, 10)": "_callback, 10, callback_group=MutuallyExclusiveCallbackGroup())"}
_TIMER_ALONE = {"self.timer_callback)": "self.timer_callback, MutuallyExclusiveCallbackGroup())"}
_AT_ONCE = _THREADS | {
    "from rclpy.executors import ExternalShutdownException\n": _IMPORTS.replace("MutuallyExclusive", "Reentrant"),
}
_GROUP = {"self.picture_callback, 1)": "self.picture_callback, 1, callback_group=MutuallyExclusiveCallbackGroup())"}
AFTER = """
Ctrl-C often comes while a picture is looked at. The thread that looks then logs its line after `rclpy` has been shut
down, and ROS says so: `Failed to publish log message to rosout`.
"""
RIGHT = [
    _THREADS | _GROUP,
    _AT_ONCE
    | {
        "self.offset = 0.0\n": "self.offset = 0.0\n        at_once = ReentrantCallbackGroup()\n",
        "_callback, 10)": "_callback, 10, callback_group=at_once)",
        "_callback, 1)": "_callback, 1, callback_group=at_once)",
        "self.timer_callback)": "self.timer_callback, at_once)",
        "MultiThreadedExecutor(2)": "MultiThreadedExecutor()",
    },
    {
        "import time\n": "import time\nfrom threading import Thread\n",
        "    def picture_callback(self, message):\n": "    def picture_callback(self, message):\n"
        "        Thread(target=self.look, args=(message,), daemon=True).start()\n\n"
        "    def look(self, message):\n",
    },
    {
        "import time\n": "import queue\nimport threading\nimport time\n",
        "        self.create_timer(0.1": "        self.pictures = queue.Queue()\n"
        "        threading.Thread(target=self.look, daemon=True).start()\n        self.create_timer(0.1",
        "        time.sleep(0.3)  # looks for people\n": "        self.pictures.put(message)\n\n"
        "    def look(self):\n        while True:\n            message = self.pictures.get()\n"
        "            time.sleep(0.3)\n            self.say(message)\n\n    def say(self, message):\n",
    },
    _AT_ONCE
    | {
        "spin(driver_py_node, MultiThreadedExecutor(2))": "get_global_executor",
        "        rclpy.get_global_executor\n": "        executor = MultiThreadedExecutor(num_threads=3)\n"
        "        executor.add_node(driver_py_node)\n        executor.spin()\n",
    }
    | {"self.picture_callback, 1)": "self.picture_callback, 1, callback_group=ReentrantCallbackGroup())"},
]
WRONG = [
    (
        _THREADS | _GROUP | {"self.create_timer(0.1": "self.create_timer(0.05"},
        "160 commands came in 8 s, one every 0.05 s",
    ),
    (_THREADS | _GROUP | {"self.create_timer(0.1": "self.create_timer(0.2"}, "10 times a second is one every 0.1 s"),
    (
        _THREADS
        | _GROUP
        | {
            "        self.create_timer(0.1, self.timer_callback)\n": "",
            "self.offset = message.data\n": "self.offset = message.data\n        self.timer_callback()\n",
        },
        "No timer of the node sends the commands.",
    ),
    (
        _THREADS | _GROUP | {"rclpy.spin(driver_py_node, MultiThreadedExecutor(2))": "MultiThreadedExecutor(2).spin()"},
        "Does the executor that spins have the node: `add_node(...)`?",
    ),
    (_THREADS | {"_callback, 1)": "_callback, 1, callbackgroup=None)"}, "That argument is called `callback_group`."),
    ({}, "the executor that spins has one thread"),
    (_THREADS, "The executor has threads enough now"),
    (
        _THREADS
        | _GROUP
        | {
            "rclpy.spin(driver_py_node, MultiThreadedExecutor(2))": "MultiThreadedExecutor().add_node(driver_py_node)"
            "\n        rclpy.spin(driver_py_node)"
        },
        "the executor that spins has one thread",
    ),
    (
        _THREADS | {"MultiThreadedExecutor(2)": "MultiThreadedExecutor"},
        "An executor is made with `()`",
    ),
    (_THREADS | _LINE_ALONE, "commands came in 8 s, where 80 are asked for"),
    (_THREADS | _GROUP | {"self.offset = message": "time.sleep(0.3)\n        self.offset = message"}, "More than one"),
    (_THREADS | _TIMER_ALONE, "The commands come often enough, but from an old offset"),
    (_THREADS | _GROUP | {'"line"': '"lines"'}, "It subscribes to `/lines`"),
    (_THREADS | _GROUP | {'"picture"': '"pictures"'}, "does not subscribe to it"),
    (
        {"import ExternalShutdownException": "import ExternalShutdownException, MutuallyExclusiveCallbackGroup"},
        "`from rclpy.callback_groups import MutuallyExclusiveCallbackGroup`",
    ),
    (
        {"import ExternalShutdownException": "import ExternalShutdownException, MultiThreadExecutor"},
        "`rclpy.executors` has a `MultiThreadedExecutor`",
    ),
    (
        _GROUP | {"from rclpy.executors import ExternalShutdownException\n": _IMPORTS},
        "the executor that spins has one thread",
    ),
    ({"        time.sleep(0.3)  # looks for people\n": ""}, "had not been looked at for 0.3 s"),
    ({"time.sleep(0.3)": "time.sleep(0.1)"}, "had not been looked at for 0.3 s"),
    (
        {'        self.create_subscription(UInt32, "picture", self.picture_callback, 1)\n': ""},
        "0 pictures were looked at",
    ),
    ({"self.create_timer(0.1": "self.create_timer(0.01"}, "leaves its line"),
    ({"linear.x = 2.0": "linear.x = 0.7"}, "leaves its line"),
    (
        _THREADS
        | {
            "_callback, 10)": "_callback, 10, callback_group=self.own)",
            "_callback, 1)": "_callback, 1, callback_group=self.own)",
            "self.offset = 0.0\n": "self.offset = 0.0\n        self.own = MutuallyExclusiveCallbackGroup()\n",
        },
        "It is what looks at pictures that needs a group",
    ),
]

SOLUTION_CPP = {
    "    camera_ = create": "    group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);\n"
    "    rclcpp::SubscriptionOptions options;\n"
    "    options.callback_group = group_;\n"
    "    camera_ = create",
    "{ pictureCallback(message); });": "{ pictureCallback(message); }, options);",
    "  rclcpp::TimerBase::SharedPtr timer_;\n": "  rclcpp::TimerBase::SharedPtr timer_;\n"
    "  rclcpp::CallbackGroup::SharedPtr group_;\n",
    "  rclcpp::spin(std::make_shared<DriverCppNode>());\n": "  auto node = std::make_shared<DriverCppNode>();\n"
    "  rclcpp::executors::MultiThreadedExecutor executor;\n"
    "  executor.add_node(node);\n"
    "  executor.spin();\n",
}

RIGHT_CPP = [
    {"CallbackGroupType::MutuallyExclusive": "CallbackGroupType::Reentrant"},
]
WRONG_CPP = [
    ({"MultiThreadedExecutor": "SingleThreadedExecutor"}, "leaves its line", "nothing steers"),
    ({", options);": ");"}, "leaves its line", "nothing steers"),
    ({"sleep_for(300ms)": "sleep_for(30ms)"}, "had not been looked at for 0.3 s", "0.3 s for a picture"),
]
