#include "ros/ros.h"

class SpinnerCppNode
{
public:
  // Start the timer
  explicit SpinnerCppNode(ros::NodeHandle& nh)
  {
    double timer_delta_t_in_seconds = 0.5;
    bool timer_is_one_shot = false;
    timer_for_counting_ = nh.createTimer(
        ros::Duration(timer_delta_t_in_seconds),
        &SpinnerCppNode::timerCallback, this, timer_is_one_shot);
  }

private:
  // Respond to the timer
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
    // Display the current counter value
    ROS_INFO_STREAM("[SPINNER CPP NODE] counter = " << counter_);
  }

  // Members, which live as long as the object
  unsigned int counter_ = 0;
  ros::Timer timer_for_counting_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "spinner_cpp_node");

  // Start the node; "~" gives the handle the node's own namespace
  ros::NodeHandle nh("~");

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[SPINNER CPP NODE] namespace of nh = " << nh.getNamespace());

  // Start an instance of the class
  SpinnerCppNode spinner_cpp_node(nh);

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
