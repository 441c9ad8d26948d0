#include <chrono>
#include <memory>
#include <thread>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("rate_working_checked");
  rclcpp::Rate rate(0.5);
  while (rclcpp::ok())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    if (!rclcpp::ok())
      break;
    rclcpp::spin_some(node);
    rate.sleep();
  }
  return 0;
}
