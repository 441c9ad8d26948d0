#include <mutex>

#include "ros/ros.h"

class OdometerCppNode
{
public:
  OdometerCppNode()
  {
    read_timer_ = nh_.createTimer(
        ros::Duration(0.5), &OdometerCppNode::readCallback, this);
    report_timer_ = nh_.createTimer(
        ros::Duration(0.6), &OdometerCppNode::reportCallback, this);
  }

private:
  // Read both wheels, one after the other
  void readCallback(const ros::TimerEvent&)
  {
    std::lock_guard<std::mutex> guard(mutex_);
    left_++;
    ros::Duration(0.25).sleep();  // the sensor is slow
    right_++;
  }

  // Report both wheels
  void reportCallback(const ros::TimerEvent&)
  {
    std::lock_guard<std::mutex> guard(mutex_);
    ROS_INFO_STREAM("[WHEELS] left = "
        << left_ << ", right = " << right_);
  }

  // Turns of the wheels: always a pair
  int left_ = 0;
  int right_ = 0;
  // Whoever touches them holds this mutex
  std::mutex mutex_;

  ros::NodeHandle nh_;
  ros::Timer read_timer_;
  ros::Timer report_timer_;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "odometer_cpp_node");
  OdometerCppNode odometer_cpp_node;

  // Two threads: a callback can run while another one sleeps
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::waitForShutdown();

  return 0;
}
