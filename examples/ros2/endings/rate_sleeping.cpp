#include <memory>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("rate_sleeping");
  rclcpp::Rate rate(0.5);
  while (rclcpp::ok())
  {
    rclcpp::spin_some(node);
    rate.sleep();
  }
  return 0;
}
