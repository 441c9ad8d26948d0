// Scenarios for roscpp on who connects to a topic and what the master knows, one for each run: ~scenario says which. Each
// line begins with the time since the start, in s, to the nearest tenth.

#include <ros/callback_queue.h>
#include <std_msgs/String.h>

#include "ros1.hpp"

namespace
{
void hear(const std_msgs::UInt32::ConstPtr& message) { say("heard " + std::to_string(message->data)); }
void connected(const ros::SingleSubscriberPublisher& to) { say("connected " + to.getSubscriberName() + " " + to.getTopic()); }
void gone(const ros::SingleSubscriberPublisher& to) { say("gone " + to.getSubscriberName() + " " + to.getTopic()); }

void spin_for(double seconds)
{
  for (ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds); ros::WallTime::now() < end && ros::ok();)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
}

Scenarios scenarios()
{
  using ros::NodeHandle;
  Scenarios all;
  all["told"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    spin_for(0.5);
    {
      ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
      spin_for(0.5);
    }
    spin_for(0.5);
    ros::Subscriber again = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    publisher.shutdown();
    spin_for(0.5);
  };
  all["told_of_those_before"] = [](NodeHandle& nh)
  {
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    ros::Publisher one = nh.advertise<std_msgs::UInt32>("topic", 10);
    spin_for(0.5);
    ros::Publisher other = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    say("advertised");
    spin_for(0.5);
  };
  all["told_once_for_two_subscribers"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    ros::Subscriber one = nh.subscribe("topic", 10, hear);
    ros::Subscriber other = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    one.shutdown();
    spin_for(0.5);
    other.shutdown();
    spin_for(0.5);
  };
  all["both_publishers_are_told"] = [](NodeHandle& nh)
  {
    ros::Publisher one = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    ros::Publisher other = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    one.shutdown();
    subscriber.shutdown();
    spin_for(0.5);
  };
  all["published_to_one"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>(
        "topic", 10, [](const ros::SingleSubscriberPublisher& to) { to.publish(number(7)); }, gone);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    publisher.publish(number(1));
    spin_for(0.5);
  };
  all["a_function_in_place_of_latch"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10, connected);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    say(publisher.isLatched() ? "latched" : "not latched");
    spin_for(0.5);
  };
  all["told_in_a_queue_of_its_own"] = [](NodeHandle& nh)
  {
    ros::CallbackQueue queue;
    ros::AdvertiseOptions options;
    options.init<std_msgs::UInt32>("topic", 10, connected, gone);
    options.callback_queue = &queue;
    ros::Publisher publisher = nh.advertise(options);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    say("calls");
    queue.callAvailable();
    spin_for(0.5);
  };
  all["not_told_without_its_object"] = [](NodeHandle& nh)
  {
    boost::shared_ptr<int> tracked(new int);
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone, tracked);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    spin_for(0.5);
    tracked.reset();
    subscriber.shutdown();
    spin_for(0.5);
  };
  all["not_told_after_its_end"] = [](NodeHandle& nh)
  {
    ros::Publisher other;
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10,
        [&](const ros::SingleSubscriberPublisher& to)
        {
          connected(to);
          other.shutdown();
        });
    other = nh.advertise<std_msgs::UInt32>("topic", 10, connected, gone);
    ros::Subscriber subscriber = nh.subscribe("topic", 10, hear);
    ros::WallDuration(0.3).sleep();  // so that both are due
    spin_for(0.5);
  };
  all["own_topics"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Publisher other = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Publisher text = nh.advertise<std_msgs::String>("/text", 10);
    ros::Subscriber subscriber = nh.subscribe("heard", 10, hear);
    ros::V_string topics;
    ros::this_node::getAdvertisedTopics(topics);
    for (const std::string& each : topics)
      say("advertised " + each);
    ros::this_node::getSubscribedTopics(topics);
    for (const std::string& each : topics)
      say("subscribed " + each);
    text.shutdown();
    other.shutdown();
    ros::this_node::getAdvertisedTopics(topics);
    for (const std::string& each : topics)
      say("advertised " + each);
  };
  all["known_to_the_master"] = [](NodeHandle& nh)
  {
    ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 10);
    ros::Publisher text = nh.advertise<std_msgs::String>("/text", 10);
    ros::Subscriber subscriber = nh.subscribe("heard", 10, hear);
    ros::master::V_TopicInfo topics;
    ros::master::getTopics(topics);
    std::map<std::string, std::string> sorted;
    for (const ros::master::TopicInfo& each : topics)
      sorted[each.name] = each.datatype;
    for (const auto& [name, type] : sorted)
      say(name + ": " + type);
    ros::V_string nodes;
    say(ros::master::getNodes(nodes) ? "nodes" : "no nodes");
    for (const std::string& each : nodes)
      say(each);
  };
  return all;
}
}  // namespace

int main(int argc, char** argv) { return run(argc, argv); }
