#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

class PublisherCppNode : public rclcpp::Node
{
public:
  // Start the node
  PublisherCppNode() : Node("publisher_cpp_node")
  {
    // Display the namespace of the node
    RCLCPP_INFO_STREAM(get_logger(),
        "[PUBLISHER CPP NODE] namespace of node = " << get_namespace());

    // Start the publisher, and then the timer that uses it
    publisher_ = create_publisher<std_msgs::msg::UInt32>("counter", 10);

    std::chrono::duration<double> timer_delta_t_in_seconds(0.5);
    timer_for_counting_ = create_timer(
        timer_delta_t_in_seconds, [this] { timerCallback(); });
  }

private:
  // Respond to the timer
  void timerCallback()
  {
    counter_++;
    // Publish the current counter value
    std_msgs::msg::UInt32 message;
    message.data = counter_;
    publisher_->publish(message);
  }

  // Start counting from zero
  unsigned int counter_ = 0;

  // Keep both: each ends when nothing holds it any more
  rclcpp::Publisher<std_msgs::msg::UInt32>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_for_counting_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as -r __ns:=/mrp)
  rclcpp::init(argc, argv);

  // Start an instance of the class
  auto publisher_cpp_node = std::make_shared<PublisherCppNode>();

  // Call the callbacks until shutdown
  rclcpp::spin(publisher_cpp_node);

  return 0;
}
