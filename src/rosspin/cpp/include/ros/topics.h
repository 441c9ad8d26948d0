// Publishers and subscribers of roscpp. The host carries their messages, serialised.
#ifndef ROSSPIN_ROS_TOPICS_H
#define ROSSPIN_ROS_TOPICS_H

#include "ros/ros.h"

namespace ros
{
class TransportHints
{
public:
  TransportHints& reliable() { return *this; }
  TransportHints& unreliable() { return *this; }
  TransportHints& tcp() { return *this; }
  TransportHints& udp() { return *this; }
  TransportHints& tcpNoDelay(bool = true) { return *this; }
  TransportHints& maxDatagramSize(int) { return *this; }
};

// Publishes to one node that has subscribed.
class SingleSubscriberPublisher
{
public:
  SingleSubscriberPublisher(const std::string& topic, const std::string& name, std::int64_t publication, std::int64_t link)
    : topic_(topic), name_(name), publication_(publication), link_(link)
  {
  }
  template<class M>
  void publish(const M& message) const
  {
    if constexpr (serialization::IsMessage<M>::value)
      send(serialization::serialized(message));
    else
      publish(*message);  // a pointer to one
  }
  std::string getTopic() const { return topic_; }
  std::string getSubscriberName() const { return name_; }

private:
  void send(const std::string& bytes) const;
  std::string topic_, name_;
  std::int64_t publication_, link_;
};
typedef boost::function<void(const SingleSubscriberPublisher&)> SubscriberStatusCallback;

struct AdvertiseOptions
{
  AdvertiseOptions() = default;
  template<class M>
  void init(const std::string& name, std::uint32_t size,
      const SubscriberStatusCallback& connect = SubscriberStatusCallback(),
      const SubscriberStatusCallback& disconnect = SubscriberStatusCallback())
  {
    topic = name;
    queue_size = size;
    datatype = M::rosspin_type;
    connect_cb = connect;
    disconnect_cb = disconnect;
  }
  template<class M>
  static AdvertiseOptions create(const std::string& name, std::uint32_t size, const SubscriberStatusCallback& connect,
      const SubscriberStatusCallback& disconnect, const VoidConstPtr& tracked, CallbackQueueInterface* queue)
  {
    AdvertiseOptions options;
    options.init<M>(name, size, connect, disconnect);
    options.tracked_object = tracked;
    options.callback_queue = queue;
    return options;
  }
  std::string topic, datatype;
  std::uint32_t queue_size = 0;
  SubscriberStatusCallback connect_cb, disconnect_cb;
  CallbackQueueInterface* callback_queue = nullptr;
  VoidConstPtr tracked_object;
  bool latch = false;
};

template<class M>
class MessageEvent
{
public:
  typedef std::remove_const_t<M> Message;
  typedef boost::shared_ptr<Message const> ConstMessagePtr;

  MessageEvent() = default;
  MessageEvent(const ConstMessagePtr& message) : MessageEvent(message, "unknown_publisher", Time::now()) {}
  MessageEvent(const ConstMessagePtr& message, const std::string& publisher, Time received)
    : message_(message), publisher_(publisher), received_(received)
  {
  }
  template<class Other>
  MessageEvent(const MessageEvent<Other>& other)
    : MessageEvent(other.getConstMessage(), other.getPublisherName(), other.getReceiptTime())
  {
  }
  boost::shared_ptr<M> getMessage() const
  {
    if constexpr (std::is_const_v<M>)
      return message_;
    else
      return boost::make_shared<Message>(*message_);
  }
  const ConstMessagePtr& getConstMessage() const { return message_; }
  const std::string& getPublisherName() const { return publisher_; }
  Time getReceiptTime() const { return received_; }

private:
  ConstMessagePtr message_;
  std::string publisher_;
  Time received_;
};

namespace detail
{
class PublicationImpl : public Kept
{
public:
  PublicationImpl(const std::string& topic, const AdvertiseOptions& options, CallbackQueueInterface* queue);
  ~PublicationImpl() override { end(); }
  void end() override;
  void publish(const char* type, const std::string& bytes);
  std::uint32_t connections() const;
  // A node has connected by a link, or is gone.
  void receive(bool connects, const std::string& node, std::int64_t link);
  std::string topic;
  std::string type;
  bool latch, ended = false;

private:
  struct StatusCall;
  SubscriberStatusCallback connect_, disconnect_;
  Tracked tracked_;
  CallbackQueueInterface* queue_;
  std::int64_t id_;
};

struct Received
{
  std::string bytes, publisher;
  std::int64_t when;
  std::shared_ptr<void const> message;  // read once for all callbacks
};

class SubscriptionImpl : public Kept
{
public:
  SubscriptionImpl(const std::string& topic, const char* type, std::uint32_t queue_size,
      std::function<void(Received&)> callback, Tracked tracked, CallbackQueueInterface* queue, bool concurrent);
  ~SubscriptionImpl() override;
  void end() override { end(true); }
  void end(bool waits);  // for a call that another thread has begun
  std::uint32_t connections() const;
  std::string topic;
  bool ended = false;
  void receive(const boost::shared_ptr<Received>& message);
  std::int64_t id() const { return id_; }

private:
  struct Queue;
  boost::shared_ptr<Queue> waiting_;
  CallbackQueueInterface* queue_;
  std::int64_t id_;
};

// How the parameter of a callback is made of a message.
template<class P>
struct Adapter
{
  typedef std::remove_cv_t<std::remove_reference_t<P>> Message;
  template<class E>
  static const Message& of(const E& event)
  {
    return *event.getConstMessage();
  }
};
template<class M>
struct Adapter<const boost::shared_ptr<M const>&>
{
  typedef M Message;
  static boost::shared_ptr<M const> of(const MessageEvent<M const>& event) { return event.getConstMessage(); }
};
template<class M>
struct Adapter<const boost::shared_ptr<M>&>
{
  typedef std::remove_const_t<M> Message;
  static boost::shared_ptr<M> of(const MessageEvent<Message const>& event)
  {
    return boost::make_shared<Message>(*event.getConstMessage());
  }
};
template<class M>
struct Adapter<boost::shared_ptr<M>> : Adapter<const boost::shared_ptr<M>&>
{
};
template<class M>
struct Adapter<boost::shared_ptr<M>&> : Adapter<const boost::shared_ptr<M>&>
{
};
template<class M>
struct Adapter<const boost::shared_ptr<M>> : Adapter<const boost::shared_ptr<M>&>
{
};
template<class M>
struct Adapter<const MessageEvent<M>&>
{
  typedef std::remove_const_t<M> Message;
  static MessageEvent<M> of(const MessageEvent<Message const>& event) { return event; }
};
template<class M>
struct Adapter<MessageEvent<M>> : Adapter<const MessageEvent<M>&>
{
};

template<class P>
std::function<void(Received&)> receiving(std::function<void(P)> callback)
{
  typedef typename Adapter<P>::Message M;
  return [callback](Received& received)
  {
    if (!received.message)
    {
      auto message = boost::make_shared<M>();
      serialization::Reader reader(received.bytes);
      M::visit(*message, reader);
      received.message = message;
    }
    MessageEvent<M const> event(std::static_pointer_cast<M const>(received.message), received.publisher,
        Time().fromNSec(received.when));
    callback(Adapter<P>::of(event));
  };
}
}  // namespace detail

class Publisher
{
public:
  Publisher() = default;
  explicit Publisher(boost::shared_ptr<detail::PublicationImpl> impl) : impl_(std::move(impl)) {}

  template<class M>
  void publish(const M& message) const
  {
    if constexpr (serialization::IsMessage<M>::value)
      send(M::rosspin_type, serialization::serialized(message));
    else
      publish(*message);  // a pointer to one
  }
  void shutdown()
  {
    if (impl_)
      impl_->end();
  }
  std::string getTopic() const { return impl_ ? impl_->topic : std::string(); }
  std::uint32_t getNumSubscribers() const { return impl_ ? impl_->connections() : 0; }
  bool isLatched() const { return impl_ && impl_->latch; }
  explicit operator bool() const { return impl_ && !impl_->ended; }
  operator void*() const { return impl_ && !impl_->ended ? impl_.get() : nullptr; }
  bool operator<(const Publisher& other) const { return impl_ < other.impl_; }
  bool operator==(const Publisher& other) const { return impl_ == other.impl_; }
  bool operator!=(const Publisher& other) const { return impl_ != other.impl_; }

private:
  void send(const char* type, const std::string& bytes) const;
  boost::shared_ptr<detail::PublicationImpl> impl_;
};
typedef std::vector<Publisher> V_Publisher;

class Subscriber
{
public:
  Subscriber() = default;
  explicit Subscriber(boost::shared_ptr<detail::SubscriptionImpl> impl) : impl_(std::move(impl)) {}
  void shutdown()
  {
    if (!impl_ || impl_->ended)
      return;
    rosspin::await_spin(-1);
    impl_->end();
  }
  std::string getTopic() const { return impl_ ? impl_->topic : std::string(); }
  std::uint32_t getNumPublishers() const { return impl_ ? impl_->connections() : 0; }
  explicit operator bool() const { return impl_ && !impl_->ended; }
  operator void*() const { return impl_ && !impl_->ended ? impl_.get() : nullptr; }
  bool operator<(const Subscriber& other) const { return impl_ < other.impl_; }
  bool operator==(const Subscriber& other) const { return impl_ == other.impl_; }
  bool operator!=(const Subscriber& other) const { return impl_ != other.impl_; }

private:
  boost::shared_ptr<detail::SubscriptionImpl> impl_;
};
typedef std::vector<Subscriber> V_Subscriber;

struct SubscribeOptions
{
  SubscribeOptions() = default;
  template<class M>
  void init(const std::string& name, std::uint32_t size,
      const boost::function<void(const boost::shared_ptr<M const>&)>& callback)
  {
    topic = name;
    queue_size = size;
    datatype = M::rosspin_type;
    receive = detail::receiving<const boost::shared_ptr<M const>&>(callback);
  }
  template<class P>
  void initByFullCallbackType(const std::string& name, std::uint32_t size, const boost::function<void(P)>& callback)
  {
    topic = name;
    queue_size = size;
    datatype = detail::Adapter<P>::Message::rosspin_type;
    receive = detail::receiving<P>(callback);
  }
  template<class M>
  static SubscribeOptions create(const std::string& name, std::uint32_t size,
      const boost::function<void(const boost::shared_ptr<M const>&)>& callback, const VoidConstPtr& tracked,
      CallbackQueueInterface* queue)
  {
    SubscribeOptions options;
    options.init<M>(name, size, callback);
    options.tracked_object = tracked;
    options.callback_queue = queue;
    return options;
  }
  std::string topic, datatype;
  std::uint32_t queue_size = 1;
  std::function<void(detail::Received&)> receive;
  CallbackQueueInterface* callback_queue = nullptr;
  bool allow_concurrent_callbacks = false;
  VoidConstPtr tracked_object;
  TransportHints transport_hints;
};
}  // namespace ros

#endif
