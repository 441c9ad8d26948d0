#ifndef ROSSPIN_ROS_FILE_LOG_H
#define ROSSPIN_ROS_FILE_LOG_H

#include "ros/ros.h"

#define ROSCPP_LOG_DEBUG(...) ROS_DEBUG_NAMED("roscpp_internal", __VA_ARGS__)
#define ROSCPP_CONN_LOG_DEBUG(...) ROS_DEBUG_NAMED("roscpp_internal.connections", __VA_ARGS__)

namespace ros::file_log
{
const std::string& getLogDirectory() ROSSPIN_NOT_SIMULATED("ros::file_log::getLogDirectory");
}  // namespace ros::file_log

#endif
