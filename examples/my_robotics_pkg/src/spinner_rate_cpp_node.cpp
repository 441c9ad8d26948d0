#include "ros/ros.h"

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "spinner_cpp_node");

  // Start the node; "~" gives the handle the node's own namespace
  ros::NodeHandle nh("~");

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[SPINNER CPP NODE] namespace of nh = " << nh.getNamespace());

  // Set the rate of the loop
  double loop_frequency_in_hz = 2.0;
  ros::Rate loop_rate(loop_frequency_in_hz);

  // Start counting from zero
  unsigned int counter = 0;

  // Loop until shutdown
  while (ros::ok())
  {
    counter++;
    // Display the current counter value
    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter);

    // Run the callbacks that are waiting, if there are any
    ros::spinOnce();

    // Sleep for what is left of this period
    loop_rate.sleep();
  }

  return 0;
}
