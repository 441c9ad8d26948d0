#include <chrono>
#include <memory>
#include <stdexcept>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("exception");
  auto timer = node->create_timer(std::chrono::milliseconds(500),
      [] { throw std::runtime_error("in a callback"); });
  rclcpp::spin(node);
  return 0;
}
