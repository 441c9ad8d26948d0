// What is compiled once for all nodes of ROS 2.
#include "rosspin/prelude.hpp"

#include "rclcpp/rclcpp.hpp"
