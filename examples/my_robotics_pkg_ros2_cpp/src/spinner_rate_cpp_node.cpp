#include <memory>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as -r __ns:=/mrp)
  rclcpp::init(argc, argv);

  // Start the node
  auto node = std::make_shared<rclcpp::Node>("spinner_cpp_node");

  // Display the namespace of the node
  RCLCPP_INFO_STREAM(node->get_logger(),
      "[SPINNER CPP NODE] namespace of node = " << node->get_namespace());

  // Set the rate of the loop
  double loop_frequency_in_hz = 2.0;
  rclcpp::Rate loop_rate(loop_frequency_in_hz);

  // Start counting from zero
  unsigned int counter = 0;

  // Loop until shutdown
  while (rclcpp::ok())
  {
    counter++;
    // Display the current counter value
    RCLCPP_INFO_STREAM(node->get_logger(),
        "[SPINNER CPP NODE] counter = " << counter);

    // Call the callbacks that are due, if there are any
    rclcpp::spin_some(node);

    // Sleep for what is left of this period
    loop_rate.sleep();
  }

  return 0;
}
