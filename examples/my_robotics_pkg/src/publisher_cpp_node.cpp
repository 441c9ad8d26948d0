#include "ros/ros.h"
#include "std_msgs/UInt32.h"

class PublisherCppNode
{
public:
  // Start the publisher, and then the timer that uses it
  explicit PublisherCppNode(ros::NodeHandle& nh)
  {
    publisher_ = nh.advertise<std_msgs::UInt32>("counter", 10);

    double timer_delta_t_in_seconds = 0.5;
    bool timer_is_one_shot = false;
    timer_for_counting_ = nh.createTimer(
        ros::Duration(timer_delta_t_in_seconds),
        &PublisherCppNode::timerCallback, this, timer_is_one_shot);
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

  // Members, which live as long as the object
  unsigned int counter_ = 0;
  ros::Publisher publisher_;
  ros::Timer timer_for_counting_;
};

int main(int argc, char* argv[])
{
  // Take ROS's own arguments (such as __ns:=/mrp); name the node
  ros::init(argc, argv, "publisher_cpp_node");

  // Start the node; without "~", names are in the node's namespace
  ros::NodeHandle nh;

  // Display the namespace of the node handle
  ROS_INFO_STREAM(
      "[PUBLISHER CPP NODE] namespace of nh = " << nh.getNamespace());

  // Start an instance of the class
  PublisherCppNode publisher_cpp_node(nh);

  // Run callbacks, one at a time in this thread, until shutdown
  ros::spin();

  return 0;
}
