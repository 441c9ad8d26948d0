#include <memory>

#include "rclcpp/rclcpp.hpp"

class PlainCppNode : public rclcpp::Node
{
public:
  // Start the node
  PlainCppNode() : Node("plain_cpp_node")
  {
    // Display the namespace of the node
    RCLCPP_INFO_STREAM(get_logger(),
        "[PLAIN CPP NODE] namespace of node = " << get_namespace());
  }
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as -r __ns:=/mrp)
  rclcpp::init(argc, argv);

  // Start an instance of the class
  auto plain_cpp_node = std::make_shared<PlainCppNode>();

  // Call the callbacks until shutdown
  rclcpp::spin(plain_cpp_node);

  return 0;
}
