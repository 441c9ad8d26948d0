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
  // Take ROS's own arguments (such as _frequency:=10); name the node
  ros::init(argc, argv, "spinner_cpp_node");

  // Start the node; "~" gives the handle the node's own namespace
  ros::NodeHandle nh("~");

  // Read the private parameter; 2.0 if it is not set
  double frequency_in_hz = 2.0;
  nh.param("frequency", frequency_in_hz, 2.0);

  // Refuse what no timer can do
  if (frequency_in_hz <= 0)
  {
    ROS_FATAL_STREAM("[SPINNER CPP NODE] frequency must be above 0");
    return 1;
  }

  // Start the timer, which takes a period
  double timer_delta_t_in_seconds = 1.0 / frequency_in_hz;
  bool timer_is_one_shot = false;
  ros::Timer timer_for_counting = nh.createTimer(
      ros::Duration(timer_delta_t_in_seconds),
      timerCallback, timer_is_one_shot);

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
