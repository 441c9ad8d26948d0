#include "ros/ros.h"

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "plain_cpp_node");

  // Start the node; "~" gives the handle the node's own namespace
  ros::NodeHandle nh("~");

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[PLAIN CPP NODE] namespace of nh = " << nh.getNamespace());

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
