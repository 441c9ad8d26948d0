#include <chrono>
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("in_callback");
  auto timer = node->create_timer(std::chrono::milliseconds(500),
      [] { std::this_thread::sleep_for(std::chrono::milliseconds(1500)); });
  rclcpp::spin(node);
  return 0;
}
