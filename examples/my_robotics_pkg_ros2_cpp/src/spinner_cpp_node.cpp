#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"

class SpinnerCppNode : public rclcpp::Node
{
public:
  // Start the node
  SpinnerCppNode() : Node("spinner_cpp_node")
  {
    // Display the namespace of the node
    RCLCPP_INFO_STREAM(get_logger(),
        "[SPINNER CPP NODE] namespace of node = " << get_namespace());

    // Start the timer
    std::chrono::duration<double> timer_delta_t_in_seconds(0.5);
    timer_for_counting_ = create_timer(
        timer_delta_t_in_seconds, [this] { timerCallback(); });
  }

private:
  // Respond to the timer
  void timerCallback()
  {
    counter_++;
    // Display the current counter value
    RCLCPP_INFO_STREAM(get_logger(),
        "[SPINNER CPP NODE] counter = " << counter_);
  }

  // Start counting from zero
  unsigned int counter_ = 0;

  // Keep the timer: it ends when nothing holds it any more
  rclcpp::TimerBase::SharedPtr timer_for_counting_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as -r __ns:=/mrp)
  rclcpp::init(argc, argv);

  // Start an instance of the class
  auto spinner_cpp_node = std::make_shared<SpinnerCppNode>();

  // Call the callbacks until shutdown
  rclcpp::spin(spinner_cpp_node);

  return 0;
}
