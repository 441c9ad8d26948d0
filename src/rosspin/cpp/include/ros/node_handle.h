// The node handle of roscpp, and the functions that need one.
#ifndef ROSSPIN_ROS_NODE_HANDLE_H
#define ROSSPIN_ROS_NODE_HANDLE_H

#include "ros/ros.h"
#include "ros/services.h"

namespace ros
{
namespace detail
{
bool read(const rosspin::Value& value, std::string& out);
bool read(const rosspin::Value& value, double& out);
bool read(const rosspin::Value& value, float& out);
bool read(const rosspin::Value& value, int& out);
bool read(const rosspin::Value& value, bool& out);

template<class T>
bool read(const rosspin::Value& value, std::vector<T>& out)
{
  if (value.kind != rosspin::Value::list)
    return false;
  std::vector<T> items;
  for (const rosspin::Value& item : value.items)
  {
    T one{};
    if (!read(item, one))
      return false;
    items.push_back(one);
  }
  out = items;
  return true;
}

template<class T>
bool read(const rosspin::Value& value, std::map<std::string, T>& out)
{
  if (value.kind != rosspin::Value::table)
    return false;
  std::map<std::string, T> fields;
  for (const auto& [name, field] : value.fields)
    if (!read(field, fields[name]))
      return false;
  out = fields;
  return true;
}

inline rosspin::Value written(const std::string& value) { return value; }
inline rosspin::Value written(const char* value) { return value; }
inline rosspin::Value written(double value) { return value; }
inline rosspin::Value written(int value) { return value; }
inline rosspin::Value written(bool value) { return value; }

template<class T>
rosspin::Value written(const std::vector<T>& values)
{
  std::vector<rosspin::Value> items;
  for (const T& value : values)
    items.push_back(written(value));
  return items;
}

template<class T>
rosspin::Value written(const std::map<std::string, T>& values)
{
  std::map<std::string, rosspin::Value> fields;
  for (const auto& [name, value] : values)
    fields[name] = written(value);
  return fields;
}
}  // namespace detail

namespace param
{
bool get(const std::string& name, rosspin::Value& value);
template<class T>
bool get(const std::string& name, T& value)
{
  rosspin::Value found;
  return get(name, found) && detail::read(found, value);
}
template<class T>
bool getCached(const std::string& name, T& value)
{
  return get(name, value);
}
template<class T>
bool param(const std::string& name, T& value, const T& otherwise)
{
  if (get(name, value))
    return true;
  value = otherwise;
  return false;
}
template<class T>
T param(const std::string& name, const T& otherwise)
{
  T value;
  param(name, value, otherwise);
  return value;
}
void set_value(const std::string& name, const rosspin::Value& value);
template<class T>
void set(const std::string& name, const T& value)
{
  set_value(name, detail::written(value));
}
bool has(const std::string& name);
bool del(const std::string& name);
bool search(const std::string& ns, const std::string& name, std::string& found);
bool search(const std::string& name, std::string& found);
bool getParamNames(V_string& names);
}  // namespace param

class NodeHandle;
typedef boost::shared_ptr<NodeHandle> NodeHandlePtr;

class NodeHandle
{
public:
  NodeHandle(const std::string& ns = std::string(), const M_string& remappings = M_string());
  NodeHandle(const NodeHandle& other);
  NodeHandle(const NodeHandle& parent, const std::string& ns, const M_string& remappings = M_string());
  ~NodeHandle();
  NodeHandle& operator=(const NodeHandle& other);

  const std::string& getNamespace() const { return namespace_; }
  const std::string& getUnresolvedNamespace() const { return unresolved_; }
  std::string resolveName(const std::string& name, bool remap = true) const;
  void setCallbackQueue(CallbackQueueInterface* queue) { queue_ = queue; }
  CallbackQueueInterface* getCallbackQueue() const { return queue_ ? queue_ : getGlobalCallbackQueue(); }
  bool ok() const { return ok_ && ros::ok(); }
  void shutdown();

  // --- timers ---

#define ROSSPIN_TIMERS(Kind, D, clock)                                                                                 \
  template<class T>                                                                                                    \
  Kind create##Kind(D period, void (T::*callback)(const Kind##Event&), T* object, bool oneshot = false,                \
      bool autostart = true) const                                                                                     \
  {                                                                                                                    \
    return make<Kind>(period, [=](const Kind##Event& event) { (object->*callback)(event); },                           \
        rosspin::name_of(callback), VoidConstPtr(), nullptr, oneshot, autostart, clock);                               \
  }                                                                                                                    \
  template<class T>                                                                                                    \
  Kind create##Kind(D period, void (T::*callback)(const Kind##Event&) const, T* object, bool oneshot = false,          \
      bool autostart = true) const                                                                                     \
  {                                                                                                                    \
    return make<Kind>(period, [=](const Kind##Event& event) { (object->*callback)(event); },                           \
        rosspin::name_of(callback), VoidConstPtr(), nullptr, oneshot, autostart, clock);                               \
  }                                                                                                                    \
  template<class T>                                                                                                    \
  Kind create##Kind(D period, void (T::*callback)(const Kind##Event&), const boost::shared_ptr<T>& object,             \
      bool oneshot = false, bool autostart = true) const                                                               \
  {                                                                                                                    \
    T* raw = object.get();                                                                                             \
    return make<Kind>(period, [=](const Kind##Event& event) { (raw->*callback)(event); },                              \
        rosspin::name_of(callback), object, nullptr, oneshot, autostart, clock);                                       \
  }                                                                                                                    \
  template<class Callback>                                                                                             \
  std::enable_if_t<std::is_convertible_v<Callback, Kind##Callback>, Kind> create##Kind(                                \
      D period, const Callback& callback, bool oneshot = false, bool autostart = true) const                           \
  {                                                                                                                    \
    return make<Kind>(period, Kind##Callback(callback), rosspin::name_of(callback), VoidConstPtr(), nullptr, oneshot,  \
        autostart, clock);                                                                                             \
  }                                                                                                                    \
  Kind create##Kind(Kind##Options& options) const                                                                      \
  {                                                                                                                    \
    return make<Kind>(options.period, options.callback, rosspin::name_of(options.callback), options.tracked_object,    \
        options.callback_queue, options.oneshot, options.autostart, clock);                                            \
  }
  ROSSPIN_TIMERS(Timer, Duration, &detail::time_of<Time>)
  ROSSPIN_TIMERS(WallTimer, WallDuration, &detail::time_of<WallTime>)
  ROSSPIN_TIMERS(SteadyTimer, WallDuration, &detail::time_of<SteadyTime>)
#undef ROSSPIN_TIMERS

  // --- topics ---

  template<class M>
  Publisher advertise(const std::string& topic, std::uint32_t queue_size, bool latch = false)
  {
    AdvertiseOptions options;
    options.init<M>(topic, queue_size);
    options.latch = latch;
    return advertise(options);
  }
  template<class M>
  Publisher advertise(const std::string& topic, std::uint32_t queue_size, const SubscriberStatusCallback& connect,
      const SubscriberStatusCallback& disconnect = SubscriberStatusCallback(),
      const VoidConstPtr& tracked = VoidConstPtr(), bool latch = false)
  {
    AdvertiseOptions options = AdvertiseOptions::create<M>(topic, queue_size, connect, disconnect, tracked, nullptr);
    options.latch = latch;
    return advertise(options);
  }
  Publisher advertise(AdvertiseOptions& options);

  template<class P, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (T::*callback)(P), T* object,
      const TransportHints& = TransportHints())
  {
    return subscribed<P>(topic, queue_size, [=](P message) { (object->*callback)(message); });
  }
  template<class P, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (T::*callback)(P) const, T* object,
      const TransportHints& = TransportHints())
  {
    return subscribed<P>(topic, queue_size, [=](P message) { (object->*callback)(message); });
  }
  template<class P, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (T::*callback)(P),
      const boost::shared_ptr<T>& object, const TransportHints& = TransportHints())
  {
    T* raw = object.get();
    return subscribed<P>(topic, queue_size, [=](P message) { (raw->*callback)(message); }, object);
  }
  template<class P, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (T::*callback)(P) const,
      const boost::shared_ptr<T>& object, const TransportHints& = TransportHints())
  {
    T* raw = object.get();
    return subscribed<P>(topic, queue_size, [=](P message) { (raw->*callback)(message); }, object);
  }
  template<class P>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, void (*callback)(P),
      const TransportHints& = TransportHints())
  {
    return subscribed<P>(topic, queue_size, callback);
  }
  // The same with the message named, as in subscribe<std_msgs::String>.
  template<class M, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size,
      void (T::*callback)(const boost::shared_ptr<M const>&), T* object, const TransportHints& = TransportHints())
  {
    typedef const boost::shared_ptr<M const>& P;
    return subscribed<P>(topic, queue_size, [=](P message) { (object->*callback)(message); });
  }
  template<class M, class T>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size,
      void (T::*callback)(const boost::shared_ptr<M const>&) const, T* object, const TransportHints& = TransportHints())
  {
    typedef const boost::shared_ptr<M const>& P;
    return subscribed<P>(topic, queue_size, [=](P message) { (object->*callback)(message); });
  }
  template<class M>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size,
      void (*callback)(const boost::shared_ptr<M const>&), const TransportHints& = TransportHints())
  {
    return subscribed<const boost::shared_ptr<M const>&>(topic, queue_size, callback);
  }
  template<class M>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size,
      const boost::function<void(const boost::shared_ptr<M const>&)>& callback,
      const VoidConstPtr& tracked = VoidConstPtr(), const TransportHints& = TransportHints())
  {
    return subscribed<const boost::shared_ptr<M const>&>(topic, queue_size, callback, tracked);
  }
  template<class M, class P>
  Subscriber subscribe(const std::string& topic, std::uint32_t queue_size, const boost::function<void(P)>& callback,
      const VoidConstPtr& tracked = VoidConstPtr(), const TransportHints& = TransportHints())
  {
    return subscribed<P>(topic, queue_size, callback, tracked);
  }
  Subscriber subscribe(SubscribeOptions& options)
  {
    options.topic = resolveName(options.topic);
    return subscribed(options.topic, options.datatype.c_str(), options.queue_size, options.receive,
        options.tracked_object, options.callback_queue, options.allow_concurrent_callbacks);
  }

  // --- services ---

  template<class T, class MReq, class MRes>
  ServiceServer advertiseService(const std::string& service, bool (T::*callback)(MReq&, MRes&), T* object)
  {
    return advertiseService<MReq, MRes>(
        service, [=](MReq& request, MRes& response) { return (object->*callback)(request, response); });
  }
  template<class T, class MReq, class MRes>
  ServiceServer advertiseService(
      const std::string& service, bool (T::*callback)(MReq&, MRes&), const boost::shared_ptr<T>& object)
  {
    T* raw = object.get();
    return advertiseService<MReq, MRes>(
        service, [=](MReq& request, MRes& response) { return (raw->*callback)(request, response); }, object);
  }
  template<class T, class MReq, class MRes>
  ServiceServer advertiseService(
      const std::string& service, bool (T::*callback)(ServiceEvent<MReq, MRes>&), T* object)
  {
    return advertiseService<ServiceEvent<MReq, MRes>>(
        service, [=](ServiceEvent<MReq, MRes>& event) { return (object->*callback)(event); });
  }
  template<class MReq, class MRes>
  ServiceServer advertiseService(const std::string& service, bool (*callback)(MReq&, MRes&))
  {
    return advertiseService<MReq, MRes>(service, boost::function<bool(MReq&, MRes&)>(callback));
  }
  template<class MReq, class MRes>
  ServiceServer advertiseService(const std::string& service, bool (*callback)(ServiceEvent<MReq, MRes>&))
  {
    typedef ServiceEvent<MReq, MRes> Event;
    return advertiseService<Event>(service, boost::function<bool(Event&)>(callback));
  }
  template<class MReq, class MRes>
  ServiceServer advertiseService(const std::string& service, const boost::function<bool(MReq&, MRes&)>& callback,
      const VoidConstPtr& tracked = VoidConstPtr())
  {
    AdvertiseServiceOptions options;
    options.init<MReq, MRes>(service, callback);
    options.tracked_object = tracked;
    return advertiseService(options);
  }
  template<class Event>
  ServiceServer advertiseService(const std::string& service, const boost::function<bool(Event&)>& callback,
      const VoidConstPtr& tracked = VoidConstPtr())
  {
    AdvertiseServiceOptions options;
    options.initBySpecType<Event>(service, callback);
    options.tracked_object = tracked;
    return advertiseService(options);
  }
  ServiceServer advertiseService(AdvertiseServiceOptions& options);
  template<class MReq, class MRes>
  ServiceClient serviceClient(const std::string& name, bool persistent = false, const M_string& = M_string())
  {
    return client(name, persistent);
  }
  template<class S>
  ServiceClient serviceClient(const std::string& name, bool persistent = false, const M_string& = M_string())
  {
    return client(name, persistent);
  }

  // --- parameters ---

  template<class T>
  bool getParam(const std::string& name, T& value) const
  {
    return param::get(resolveName(name), value);
  }
  template<class T>
  bool getParamCached(const std::string& name, T& value) const
  {
    return getParam(name, value);
  }
  template<class T>
  bool param(const std::string& name, T& value, const T& otherwise) const
  {
    if (getParam(name, value))
      return true;
    value = otherwise;
    return false;
  }
  template<class T>
  T param(const std::string& name, const T& otherwise) const
  {
    T value;
    param(name, value, otherwise);
    return value;
  }
  template<class T>
  void setParam(const std::string& name, const T& value) const
  {
    param::set(resolveName(name), value);
  }
  bool hasParam(const std::string& name) const { return param::has(resolveName(name)); }
  bool deleteParam(const std::string& name) const { return param::del(resolveName(name)); }
  bool searchParam(const std::string& name, std::string& found) const
  {
    return param::search(getNamespace(), name, found);
  }
  bool getParamNames(V_string& names) const { return param::getParamNames(names); }

private:
  void construct(const std::string& ns);
  template<class Kind, class D, class Callback>
  Kind make(D period, Callback callback, const std::string& name, const VoidConstPtr& tracked,
      CallbackQueueInterface* queue, bool oneshot, bool autostart, std::int64_t (*clock)()) const
  {
    typedef std::conditional_t<std::is_same_v<Kind, Timer>, TimerEvent,
        std::conditional_t<std::is_same_v<Kind, WallTimer>, WallTimerEvent, SteadyTimerEvent>>
        Event;
    auto impl = boost::make_shared<detail::TimerImpl>(period.toNSec(),
        [callback](const detail::Called& called) { callback(Event(called)); }, name, detail::Tracked(tracked),
        queue ? queue : getCallbackQueue(), oneshot, clock);
    if (autostart)
      impl->start();
    return Kind(impl);
  }
  template<class P>
  Subscriber subscribed(const std::string& topic, std::uint32_t queue_size, std::function<void(P)> callback,
      const VoidConstPtr& tracked = VoidConstPtr())
  {
    return subscribed(topic, detail::Adapter<P>::Message::rosspin_type, queue_size,
        detail::receiving<P>(std::move(callback)), tracked, nullptr);
  }
  Subscriber subscribed(const std::string& topic, const char* type, std::uint32_t queue_size,
      std::function<void(detail::Received&)> receive, const VoidConstPtr& tracked, CallbackQueueInterface* queue,
      bool concurrent = false);
  void keep(const boost::shared_ptr<detail::Kept>& one);
  ServiceClient client(const std::string& name, bool persistent);

  std::string namespace_, unresolved_;
  M_string remappings_;
  CallbackQueueInterface* queue_ = nullptr;
  std::vector<boost::weak_ptr<detail::Kept>> kept_;  // topics
  bool ok_ = true;
};

namespace topic
{
template<class M>
boost::shared_ptr<M const> waitForMessage(const std::string& topic, NodeHandle& node, Duration timeout)
{
  boost::shared_ptr<M const> message;
  CallbackQueue queue;
  SubscribeOptions options;
  options.init<M>(topic, 1, [&](const boost::shared_ptr<M const>& each) { message = each; });
  options.callback_queue = &queue;
  Subscriber subscriber = node.subscribe(options);
  std::int64_t end = timeout.isZero() ? rosspin::never : rosspin::now() + timeout.toNSec();
  while (!message && node.ok() && rosspin::now() < end)
  {
    queue.callAvailable(WallDuration(0.1));
  }
  return message;
}
template<class M>
boost::shared_ptr<M const> waitForMessage(const std::string& topic, Duration timeout = Duration())
{
  NodeHandle node;
  return waitForMessage<M>(topic, node, timeout);
}
template<class M>
boost::shared_ptr<M const> waitForMessage(const std::string& topic, NodeHandle& node)
{
  return waitForMessage<M>(topic, node, Duration());
}
}  // namespace topic

namespace service
{
template<class MReq, class MRes>
bool call(const std::string& name, MReq& request, MRes& response)
{
  return NodeHandle().serviceClient<MReq, MRes>(names::resolve(name)).call(request, response);
}
template<class S>
bool call(const std::string& name, S& service)
{
  return call(name, service.request, service.response);
}
template<class S>
ServiceClient createClient(const std::string& name, bool persistent = false)
{
  return NodeHandle().serviceClient<S>(names::resolve(name), persistent);
}
}  // namespace service

namespace master
{
struct TopicInfo
{
  std::string name, datatype;
};
typedef std::vector<TopicInfo> V_TopicInfo;
bool getTopics(V_TopicInfo& topics);
bool getNodes(V_string& nodes);
inline bool check() { return true; }
inline std::uint32_t getPort() { return 11311; }
inline const std::string& getURI()
{
  static const std::string uri = "http://localhost:11311";
  return uri;
}
inline const std::string& getHost()
{
  static const std::string host = "localhost";
  return host;
}
}  // namespace master
}  // namespace ros

#endif
