// What message_filters need of ROS 2.
#ifndef ROSSPIN_RCLCPP_FILTERS_HPP
#define ROSSPIN_RCLCPP_FILTERS_HPP

#include "rclcpp/rclcpp.hpp"

namespace message_filters
{
template<class M>
class MessageEvent
{
public:
  typedef std::remove_const_t<M> Message;
  typedef std::shared_ptr<Message const> ConstMessagePtr;
  MessageEvent() = default;
  MessageEvent(const ConstMessagePtr& message, rclcpp::Time received = rclcpp::Clock().now())
    : message_(message), received_(received)
  {
  }
  template<class Other>
  MessageEvent(const MessageEvent<Other>& other) : MessageEvent(other.getConstMessage(), other.getReceiptTime())
  {
  }
  std::shared_ptr<M> getMessage() const
  {
    if constexpr (std::is_const_v<M>)
      return message_;
    else
      return std::make_shared<Message>(*message_);
  }
  const ConstMessagePtr& getConstMessage() const { return message_; }
  rclcpp::Time getReceiptTime() const { return received_; }

private:
  ConstMessagePtr message_;
  rclcpp::Time received_;
};

namespace detail
{
typedef rclcpp::Time Time;
typedef rclcpp::Duration Duration;
template<class M>
using Event = MessageEvent<M const>;

template<class M>
Time stamp_of(const M& message)
{
  return message.header.stamp;
}
inline std::int64_t ns(const Time& time) { return time.nanoseconds(); }
inline std::int64_t ns(const Duration& duration) { return duration.nanoseconds(); }

inline Time now() { return rclcpp::Clock().now(); }
typedef rclcpp::TimerBase::SharedPtr Timer;
template<class Call>
Timer every(Duration period, Call call, const rclcpp::Node::SharedPtr& node)
{
  return node->create_wall_timer(std::chrono::nanoseconds(ns(period)), call);
}
inline void stop(const Timer& timer) { timer->cancel(); }

inline void warn(int number, std::int64_t gap, std::int64_t bound)
{
  rclcpp::Logger logger = rclcpp::get_logger("");
  if (gap < 0)
    RCLCPP_WARN_ONCE(logger, "Messages of type %d arrived out of order (will print only once)", number);
  else
    RCLCPP_WARN_ONCE(logger,
        "Messages of type %d arrived closer (%lld) than the lower bound you provided (%lld) (will print only once)",
        number, gap, bound);
}
}  // namespace detail

template<class Node = rclcpp::Node>
class SubscriberBase
{
public:
  virtual ~SubscriberBase() = default;
  virtual void subscribe(
      Node* node, const std::string& topic, const rclcpp::QoS& qos, rclcpp::SubscriptionOptions options) = 0;
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;
};

namespace detail
{
template<class M, class Filter, class Node = rclcpp::Node>
class Subscribing : public SubscriberBase<Node>, public Filter
{
public:
  typedef std::shared_ptr<Node> NodePtr;

  Subscribing() = default;
  // A node, the topic, and perhaps a quality of service, and options.
  template<class AnyNode, class... More>
  Subscribing(AnyNode node, const std::string& topic, const More&... more)
  {
    subscribe(node, topic, more...);
  }
  ~Subscribing() override { subscription_.reset(); }
  void subscribe(
      Node* node, const std::string& topic, const rclcpp::QoS& qos, rclcpp::SubscriptionOptions options) override
  {
    unsubscribe();
    if (topic.empty())
      return;
    again_ = [=]
    {
      subscription_ = node->template create_subscription<M>(topic, qos,
          [this](std::shared_ptr<M const> message) { this->signalMessage(Event<M>(message)); }, options);
    };
    topic_ = topic;
    again_();
  }
  void subscribe(
      Node* node, const std::string& topic, const rclcpp::QoS& qos = rclcpp::QoS(10))
  {
    subscribe(node, topic, qos, rclcpp::SubscriptionOptions());
  }
  void subscribe(Node* node, const std::string& topic, const rmw_qos_profile_t& qos,
      rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
  {
    subscribe(node, topic, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos), qos), options);
  }
  template<class... More>
  void subscribe(const NodePtr& node, const std::string& topic, const More&... more)
  {
    subscribe(node.get(), topic, more...);
  }
  void subscribe() override
  {
    unsubscribe();
    if (again_)
      again_();
  }
  void unsubscribe() override { subscription_.reset(); }
  std::string getTopic() const { return topic_; }
  typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const { return subscription_; }

private:
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
  std::function<void()> again_;
  std::string topic_;
};
}  // namespace detail
}  // namespace message_filters

#endif
