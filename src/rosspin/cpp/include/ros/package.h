#ifndef ROSSPIN_ROS_PACKAGE_H
#define ROSSPIN_ROS_PACKAGE_H

#include "ros/ros.h"

namespace ros::package
{
std::string getPath(const std::string& name) ROSSPIN_NOT_SIMULATED("ros::package::getPath");
bool getAll(V_string& names) ROSSPIN_NOT_SIMULATED("ros::package::getAll");
}  // namespace ros::package

#endif
