"""A reader is told why the callbacks of a node were never called, on the command line and in a page alike."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosspin.__main__ import main
from tests.helpers.cpp_in_page import in_page

ROS1 = """\
#include "ros/ros.h"
#include "std_msgs/String.h"
#include "std_srvs/Empty.h"
void tick(const ros::TimerEvent&) {}
void hear(const std_msgs::String&) {}
bool serve(std_srvs::Empty::Request&, std_srvs::Empty::Response&) { return true; }
struct WithoutHandle
{
  WithoutHandle()
  {
    ros::NodeHandle node;
    timer = node.createTimer(ros::Duration(0.5), tick);
  }
  ros::Timer timer;
};
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::string how = argv[1];
  if (how == "handle")
  {
    WithoutHandle without;
    ros::spin();
    return 0;
  }
  ros::NodeHandle node;
  ros::Timer timer;
  ros::Subscriber subscriber;
  ros::ServiceServer server;
  ros::Publisher publisher = node.advertise<std_msgs::String>("text", 1);
  if (how == "timer" || how == "some" || how == "stopped" || how == "failed" || how == "asynchronous")
    timer = node.createTimer(ros::Duration(5.0), tick);
  if (how == "subscription" || how == "shut")
    subscriber = node.subscribe("text", 1, hear);
  if (how == "service")
    server = node.advertiseService("serve", serve);
  if (how == "lost timer")
    node.createTimer(ros::Duration(0.5), tick);
  if (how == "lost subscription")
    node.subscribe("text", 1, hear);
  if (how == "replaced")
  {
    timer = node.createTimer(ros::Duration(0.5), tick);
    timer = node.createTimer(ros::Duration(9.0), tick);
    subscriber = node.subscribe("text", 1, hear);
    subscriber = node.subscribe("text", 1, hear);
  }
  publisher.publish(std_msgs::String());
  if (how == "some")
    for (int i = 0; i < 3; i++, ros::Duration(0.1).sleep())
      ros::spinOnce();
  if (how == "stopped")
    timer.stop();
  if (how == "shut")
    subscriber.shutdown();
  if (how == "failed")
    return 1;
  if (how == "asynchronous")
  {
    ros::AsyncSpinner spinner(1);
    spinner.start();
    ros::Duration(0.2).sleep();
  }
  if (how.rfind("lost", 0) == 0 || how == "replaced")
    ros::spin();
}
"""
ROS2 = """\
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/empty.hpp"
using namespace std::chrono_literals;
using std_msgs::msg::String;
using std_srvs::srv::Empty;
struct Made : rclcpp::Node
{
  Made() : Node("node") {}
  void tick() {}
  void hear(const String&) {}
  auto make_timer(std::chrono::nanoseconds period) { return create_wall_timer(period, std::bind(&Made::tick, this)); }
  auto subscribe() { return create_subscription<String>("text", 1, [this](const String& message) { hear(message); }); }
  rclcpp::TimerBase::SharedPtr timer;
  rclcpp::Subscription<String>::SharedPtr subscription;
  rclcpp::Service<Empty>::SharedPtr service;
};
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  std::string how = argv[1];
  auto node = std::make_shared<Made>();
  auto publisher = node->create_publisher<String>("text", 1);
  if (how == "timer" || how == "some" || how == "stopped" || how == "failed" || how == "executor" || how == "until")
    node->timer = node->make_timer(5s);
  if (how == "subscription" || how == "taken")
    node->subscription = node->subscribe();
  if (how == "service")
    node->service = node->create_service<Empty>("serve", [](Empty::Request::SharedPtr, Empty::Response::SharedPtr) {});
  if (how == "lost timer")
    node->make_timer(500ms);
  if (how == "lost lambda")
    node->create_wall_timer(500ms, [] {});
  if (how == "lost subscription")
    node->subscribe();
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  if (how == "lost group" || how == "kept group")
    node->timer = node->create_wall_timer(500ms, [] {}, group);
  if (how == "lost group" || how == "subscribed group")
  {
    rclcpp::SubscriptionOptions options;
    options.callback_group = group;
    if (how == "subscribed group")
      node->subscription = node->create_subscription<String>("text", 1, [](const String&) {}, options);
    group.reset();
  }
  if (how == "replaced")
  {
    node->timer = node->make_timer(500ms);
    node->timer = node->make_timer(9s);
    node->subscription = node->subscribe();
    node->subscription = node->subscribe();
  }
  publisher->publish(String());
  if (how == "some")
    for (int i = 0; i < 3; i++, rclcpp::sleep_for(100ms))
      rclcpp::spin_some(node);
  if (how == "stopped")
    node->timer->cancel();
  if (how == "taken")
  {
    String text;
    rclcpp::MessageInfo info;
    rclcpp::sleep_for(100ms);
    node->subscription->take(text, info);
  }
  if (how == "failed")
    return 1;
  if (how == "executor")
  {
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    executor.spin_once(100ms);
  }
  if (how == "until")
  {
    std::promise<void> never;
    rclcpp::spin_until_future_complete(node, never.get_future().share(), 100ms);
  }
  if (how.rfind("lost", 0) == 0 || how == "replaced" || how.find(" group") != std::string::npos)
    rclcpp::spin(node);
  rclcpp::shutdown();
}
"""
UNSPUN = (
    "Nothing spun the node, so none of its timers, subscriptions and services called back. Is {} missing at its end?"
)
LOST = "The {} was destroyed before it could call back. Keep it in a member of the class, or in main."
HANDLE = (
    "The last ros::NodeHandle was destroyed before ros::spin(), which has shut the node down. "
    "Keep it in a member of the class, or in main."
)
UNSPUN1, UNSPUN2 = UNSPUN.format("ros::spin()"), UNSPUN.format("rclcpp::spin(node)")
SUBSCRIPTION = LOST.format("subscription to /text")

# How a node of each ROS goes about it, and what is said of that.
SAID = {
    ROS1: {
        **dict.fromkeys(("timer", "subscription", "service"), UNSPUN1),
        "handle": HANDLE,
        "lost timer": LOST.format("timer of tick"),
        "lost subscription": SUBSCRIPTION,
        **dict.fromkeys(("publishes", "some", "stopped", "shut", "failed", "asynchronous", "replaced"), ""),
    },
    ROS2: {
        **dict.fromkeys(("timer", "subscription", "service"), UNSPUN2),
        "lost timer": LOST.format("timer of tick"),
        "lost lambda": LOST.format("timer of a lambda"),
        "lost subscription": SUBSCRIPTION,
        "lost group": LOST.format("callback group"),
        **dict.fromkeys(("publishes", "some", "stopped", "taken", "failed", "executor", "until", "replaced"), ""),
        **dict.fromkeys(("kept group", "subscribed group"), ""),
    },
}


@pytest.mark.parametrize("text", SAID, ids=["ros1", "ros2"])
def test_a_node_whose_callbacks_are_never_called_is_told_why(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "node.cpp"
    file.write_text(text, encoding="utf-8")
    found = {}
    for how in SAID[text]:
        assert main(["run", str(file), "--simulated", "--seconds", "2", "--", how]) == (how == "failed")
        found[how] = [line for line in capsys.readouterr().err.splitlines() if line.startswith("rosspin: ")]
    assert found == {how: [f"rosspin: {said}"] if said else [] for how, said in SAID[text].items()}
    consoles = [console for console, _ in in_page(file, [(2.0, f"'{how}'") for how in SAID[text]], tmp_path)]
    for console, said in zip(consoles, SAID[text].values(), strict=True):
        assert console.count("destroyed") + console.count("Nothing spun") == bool(said)
        assert said in console
