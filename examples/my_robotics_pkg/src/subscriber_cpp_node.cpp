#include "ros/ros.h"
#include "std_msgs/UInt32.h"

// Declare the function prototypes
void counterCallback(const std_msgs::UInt32& message);

// Respond to a message
void counterCallback(const std_msgs::UInt32& message)
{
  // Display the counter value that has arrived
  ROS_INFO_STREAM("[SUBSCRIBER CPP NODE] counter = " << message.data);
}

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "subscriber_cpp_node");

  // Start the node; without "~", names are in the node's namespace
  ros::NodeHandle nh;

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[SUBSCRIBER CPP NODE] namespace of nh = " << nh.getNamespace());

  // Start the subscriber; local to main, so that it ends before the node
  ros::Subscriber subscriber = nh.subscribe("counter", 10, counterCallback);

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
