#include "ros/ros.h"

// Declare the function prototypes
void timerCallback(const ros::TimerEvent&);

// Respond to the timer
void timerCallback(const ros::TimerEvent&)
{
  // Static, so that the count survives from one call to the next
  static unsigned int counter = 0;
  counter++;

  // Display the current counter value
  ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter);
}

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "spinner_cpp_node");

  // Start the node; "~" gives the handle the node's own namespace
  ros::NodeHandle nh("~");

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[SPINNER CPP NODE] namespace of nh = " << nh.getNamespace());

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
