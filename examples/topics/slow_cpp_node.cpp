#include "ros/ros.h"
#include "std_msgs/UInt32.h"

class SlowCppNode
{
public:
  SlowCppNode() : nh_("~")
  {
    publisher_ = nh_.advertise<std_msgs::UInt32>("counter", 10);
    subscriber_ = nh_.subscribe("counter", nh_.param("queue_size", 1),
        &SlowCppNode::counterCallback, this);
    ros::Duration(0.5).sleep();
    timer_ = nh_.createTimer(
        ros::Duration(0.1), &SlowCppNode::timerCallback, this);
  }

private:
  // Publish 0, 1, 2 up to 29, one every 0.1 s
  void timerCallback(const ros::TimerEvent&)
  {
    std_msgs::UInt32 message;
    message.data = ++counter_;
    publisher_.publish(message);
    if (counter_ == 29)
      timer_.stop();
  }

  // Take 0.8 s for each message
  void counterCallback(const std_msgs::UInt32& message)
  {
    ROS_INFO_STREAM("[SLOW CPP NODE] counter = " << message.data);
    ros::Duration(0.8).sleep();
  }

  ros::NodeHandle nh_;
  int counter_ = -1;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  ros::Timer timer_;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "slow_cpp_node");
  SlowCppNode slow_cpp_node;
  // Two threads: the slow callback does not keep the timer waiting
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::waitForShutdown();
  return 0;
}
