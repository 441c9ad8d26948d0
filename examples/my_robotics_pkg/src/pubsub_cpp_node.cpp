#include "ros/ros.h"
#include "std_msgs/UInt32.h"

class PubsubCppNode
{
public:
  // Start the publisher, the subscriber, and then the timer
  explicit PubsubCppNode(ros::NodeHandle& nh)
  {
    publisher_ = nh.advertise<std_msgs::UInt32>("counter", 10);
    subscriber_ = nh.subscribe(
        "counter", 10, &PubsubCppNode::counterCallback, this);

    double timer_delta_t_in_seconds = 0.5;
    bool timer_is_one_shot = false;
    timer_for_counting_ = nh.createTimer(
        ros::Duration(timer_delta_t_in_seconds),
        &PubsubCppNode::timerCallback, this, timer_is_one_shot);
  }

private:
  // Respond to the timer
  void timerCallback(const ros::TimerEvent&)
  {
    counter_++;
    // Publish the current counter value
    std_msgs::UInt32 message;
    message.data = counter_;
    publisher_.publish(message);
  }

  // Respond to a message
  void counterCallback(const std_msgs::UInt32& message)
  {
    // Display the counter value that has arrived
    ROS_INFO_STREAM("[PUBSUB CPP NODE] counter = " << message.data);
  }

  // Members, which live as long as the object
  unsigned int counter_ = 0;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
  ros::Timer timer_for_counting_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "pubsub_cpp_node");

  // Start the node; without "~", names are in the node's namespace
  ros::NodeHandle nh;

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[PUBSUB CPP NODE] namespace of nh = " << nh.getNamespace());

  // Start an instance of the class
  PubsubCppNode pubsub_cpp_node(nh);

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
