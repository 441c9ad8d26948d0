// What message_filters need of ROS 1.
#ifndef ROSSPIN_ROS_FILTERS_H
#define ROSSPIN_ROS_FILTERS_H

#include "ros/ros.h"

namespace message_filters
{
namespace detail
{
typedef ros::Time Time;
typedef ros::Duration Duration;
template<class M>
using Event = ros::MessageEvent<M const>;

template<class M>
Time stamp_of(const M& message)
{
  return message.header.stamp;
}
inline std::int64_t ns(const Time& time) { return static_cast<std::int64_t>(time.toNSec()); }
inline std::int64_t ns(const Duration& duration) { return duration.toNSec(); }

inline Time now() { return Time::now(); }
typedef ros::SteadyTimer Timer;
template<class Call>
Timer every(Duration period, Call call, ros::NodeHandle node = ros::NodeHandle())
{
  return node.createSteadyTimer(ros::WallDuration(period.toSec()), [call](const ros::SteadyTimerEvent&) { call(); });
}
inline void stop(Timer& timer) { timer.stop(); }

inline void warn(int number, std::int64_t gap, std::int64_t bound)
{
  if (gap < 0)
    ROS_WARN_STREAM("Messages of type " << number << " arrived out of order (will print only once)");
  else
    ROS_WARN_STREAM("Messages of type " << number << " arrived closer (" << Duration().fromNSec(gap)
                                        << ") than the lower bound you provided (" << Duration().fromNSec(bound)
                                        << ") (will print only once)");
}
}  // namespace detail

class SubscriberBase
{
public:
  virtual ~SubscriberBase() {}
  virtual void subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
      const ros::TransportHints& hints = ros::TransportHints(), ros::CallbackQueueInterface* queue = nullptr) = 0;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};
typedef boost::shared_ptr<SubscriberBase> SubscriberBasePtr;

namespace detail
{
template<class M, class Filter, class...>
class Subscribing : public SubscriberBase, public Filter
{
public:
  Subscribing() = default;
  Subscribing(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
      const ros::TransportHints& hints = ros::TransportHints(), ros::CallbackQueueInterface* queue = nullptr)
  {
    subscribe(node, topic, queue_size, hints, queue);
  }
  ~Subscribing() override { subscriber_.shutdown(); }
  void subscribe(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue_size,
      const ros::TransportHints& = ros::TransportHints(), ros::CallbackQueueInterface* queue = nullptr) override
  {
    unsubscribe();
    if (topic.empty())
      return;
    options_.template initByFullCallbackType<const Event<M>&>(
        topic, queue_size, [this](const Event<M>& event) { this->signalMessage(event); });
    options_.callback_queue = queue;
    subscriber_ = node.subscribe(options_);
    node_ = node;
  }
  void subscribe() override
  {
    unsubscribe();
    if (!options_.topic.empty())
      subscriber_ = node_.subscribe(options_);
  }
  void unsubscribe() override { subscriber_.shutdown(); }
  std::string getTopic() const { return options_.topic; }
  const ros::Subscriber& getSubscriber() const { return subscriber_; }

private:
  ros::Subscriber subscriber_;
  ros::SubscribeOptions options_;
  ros::NodeHandle node_;
};
}  // namespace detail
}  // namespace message_filters

#endif
