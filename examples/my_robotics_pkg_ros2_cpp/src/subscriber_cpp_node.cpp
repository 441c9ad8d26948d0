#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

class SubscriberCppNode : public rclcpp::Node
{
public:
  // Start the node
  SubscriberCppNode() : Node("subscriber_cpp_node")
  {
    // Display the namespace of the node
    RCLCPP_INFO_STREAM(get_logger(),
        "[SUBSCRIBER CPP NODE] namespace of node = " << get_namespace());

    // Start the subscription
    subscription_ = create_subscription<std_msgs::msg::UInt32>("counter", 10,
        [this](const std_msgs::msg::UInt32& message)
        { counterCallback(message); });
  }

private:
  // Respond to a message
  void counterCallback(const std_msgs::msg::UInt32& message)
  {
    // Display the counter value that has arrived
    RCLCPP_INFO_STREAM(get_logger(),
        "[SUBSCRIBER CPP NODE] counter = " << message.data);
  }

  // Keep the subscription: it ends when nothing holds it any more
  rclcpp::Subscription<std_msgs::msg::UInt32>::SharedPtr subscription_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as -r __ns:=/mrp)
  rclcpp::init(argc, argv);

  // Start an instance of the class
  auto subscriber_cpp_node = std::make_shared<SubscriberCppNode>();

  // Call the callbacks until shutdown
  rclcpp::spin(subscriber_cpp_node);

  return 0;
}
