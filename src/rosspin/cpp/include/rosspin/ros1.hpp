// What is compiled once for all nodes of ROS 1.
#include "rosspin/prelude.hpp"

#include "ros/ros.h"
