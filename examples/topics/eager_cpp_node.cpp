#include "ros/ros.h"
#include "std_msgs/UInt32.h"

class EagerCppNode
{
public:
  EagerCppNode() : nh_("~")
  {
    bool latch = nh_.param("latch", false);
    publisher_ = nh_group_.advertise<std_msgs::UInt32>("counter", 10, latch);
    subscriber_ = nh_group_.subscribe(
        "counter", 10, &EagerCppNode::counterCallback, this);
    // Publish immediately, and then every 0.5 s
    timerCallback(ros::TimerEvent());
    timer_ = nh_.createTimer(
        ros::Duration(0.5), &EagerCppNode::timerCallback, this);
  }

private:
  void timerCallback(const ros::TimerEvent&)
  {
    std_msgs::UInt32 message;
    message.data = ++counter_;
    publisher_.publish(message);
  }

  void counterCallback(const std_msgs::UInt32& message)
  {
    ROS_INFO_STREAM("[EAGER CPP NODE] counter = " << message.data);
  }

  ros::NodeHandle nh_;
  ros::NodeHandle nh_group_;
  unsigned int counter_ = 0;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  ros::Timer timer_;
};

int main(int argc, char* argv[])
{
  ros::init(argc, argv, "eager_cpp_node");
  EagerCppNode eager_cpp_node;
  ros::spin();
  return 0;
}
