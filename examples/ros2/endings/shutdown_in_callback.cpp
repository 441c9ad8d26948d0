#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("shutdown_in_callback");
  auto timer = node->create_timer(
      std::chrono::milliseconds(500), [] { rclcpp::shutdown(); });
  rclcpp::spin(node);
  return 0;
}
