// What an executor of rclcpp calls, and the callback groups and the node that it belongs to.
#ifndef ROSSPIN_RCLCPP_ENTITIES_HPP
#define ROSSPIN_RCLCPP_ENTITIES_HPP

#include <atomic>
#include <deque>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/message.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
class CallbackGroup;

namespace detail
{
// Something that may have a call to make. The order of the kinds is that in which executors call them.
class Callable
{
public:
  enum Kind
  {
    timer,
    subscription,
    service,
    client,
    event
  };
  explicit Callable(Kind kind) : kind(kind) {}
  virtual ~Callable();
  // Whether there is a call to make now, and from when on, in the run's time (ns), if nothing comes.
  virtual bool is_due() const = 0;
  virtual std::int64_t due() const = 0;
  virtual void call_back() = 0;
  // Whether its group lets it be called now.
  bool is_free() const { return !free || *free; }
  const Kind kind;
  std::weak_ptr<CallbackGroup> group;
  std::shared_ptr<std::atomic_bool> free;  // the group's
};

// Grows whenever executors have to look again at what belongs to nodes, which is when that has changed.
extern std::uint64_t changes;
void changed();
}  // namespace detail

enum class CallbackGroupType
{
  MutuallyExclusive,
  Reentrant
};

namespace node_interfaces
{
class NodeBaseInterface;
}

class CallbackGroup : public std::enable_shared_from_this<CallbackGroup>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  CallbackGroup(CallbackGroupType type, bool automatic) : type_(type), automatic_(automatic) {}
  ~CallbackGroup();
  CallbackGroupType type() const { return type_; }
  std::atomic_bool& can_be_taken_from() { return *free_; }
  std::atomic_bool& get_associated_with_executor_atomic() { return taken_; }
  bool automatically_add_to_executor_with_node() const { return automatic_; }
  std::size_t size() const { return members().size(); }

  // What follows is not rclcpp's.
  void add(const std::shared_ptr<detail::Callable>& member);
  std::vector<std::shared_ptr<detail::Callable>> members() const;

private:
  CallbackGroupType type_;
  bool automatic_;
  std::shared_ptr<std::atomic_bool> free_ = std::make_shared<std::atomic_bool>(true);
  std::atomic_bool taken_{false};
  mutable std::vector<std::weak_ptr<detail::Callable>> members_;
};
namespace callback_group
{
using rclcpp::CallbackGroup;
using rclcpp::CallbackGroupType;
}  // namespace callback_group

class NodeOptions;

namespace node_interfaces
{
class NodeBaseInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeBaseInterface)
  typedef std::function<void(CallbackGroup::SharedPtr)> CallbackGroupFunction;

  NodeBaseInterface(const std::string& name, const std::string& ns, const NodeOptions& options);
  ~NodeBaseInterface();
  RCLCPP_DISABLE_COPY(NodeBaseInterface)
  const char* get_name() const { return name_.c_str(); }
  const char* get_namespace() const { return namespace_.c_str(); }
  const char* get_fully_qualified_name() const { return full_name_.c_str(); }
  Context::SharedPtr get_context() { return context_; }
  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatic = true);
  CallbackGroup::SharedPtr get_default_callback_group() { return default_group_; }
  bool callback_group_in_node(CallbackGroup::SharedPtr group);
  void for_each_callback_group(const CallbackGroupFunction& function);
  std::atomic_bool& get_associated_with_executor_atomic() { return taken_; }
  bool get_use_intra_process_default() const { return is_intra_process_; }
  std::string resolve_topic_or_service_name(
      const std::string& name, bool is_service, bool only_expand = false) const;

  // What follows is not rclcpp's.
  std::int64_t id() const { return id_; }
  const std::string& logger_name() const { return logger_; }
  const std::map<std::string, rosspin::Value>& overrides() const { return overrides_; }
  // Return the group of what should be made; raises if it is another node's.
  CallbackGroup::SharedPtr group_for(const CallbackGroup::SharedPtr& given, const char* what);
  // Ask the host something of this node; raises what it answers with.
  rosspin::Value ask(const std::string& what, std::vector<rosspin::Value> values, const char* failed) const;

private:
  Context::SharedPtr context_;
  std::int64_t id_;
  std::string name_, namespace_, full_name_, logger_;
  std::map<std::string, rosspin::Value> overrides_;
  CallbackGroup::SharedPtr default_group_;
  std::vector<CallbackGroup::WeakPtr> groups_;
  bool is_intra_process_;
  std::atomic_bool taken_{false};
};
}  // namespace node_interfaces

// --- timers ---

struct TimerInfo
{
  Time expected_call_time, actual_call_time;
};

class TimerBase : public detail::Callable, public rosspin::Ticking
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(TimerBase)
  TimerBase(Clock::SharedPtr clock, std::chrono::nanoseconds period, Context::SharedPtr context, bool autostart = true);
  ~TimerBase() override;
  RCLCPP_DISABLE_COPY(TimerBase)
  void cancel();
  bool is_canceled() const { return cancelled_; }
  void reset();
  bool is_ready() const { return !cancelled_ && clock_->ns() >= next_; }
  std::chrono::nanoseconds time_until_trigger() const;
  bool is_steady() const { return clock_->get_clock_type() == RCL_STEADY_TIME; }
  void set_on_reset_callback(std::function<void(std::size_t)> callback) { on_reset_ = std::move(callback); }
  void clear_on_reset_callback() { on_reset_ = nullptr; }
  void execute_callback() { callback_(TimerInfo{clock_->now(), clock_->now()}); }
  // Who calls it without an executor begins a call, which gives nothing if it is cancelled, and makes it.
  std::shared_ptr<void> call() { return cancelled_ ? nullptr : std::make_shared<TimerInfo>(begin_call(clock_->ns())); }
  void execute_callback(const std::shared_ptr<void>& begun) { make_call(*static_cast<TimerInfo*>(begun.get())); }

  // What follows is not rclcpp's.
  bool is_due() const override { return is_ready(); }
  std::int64_t due() const override { return cancelled_ ? rosspin::never : clock_->in_run(next_); }
  void call_back() override { call_back(clock_->ns()); }
  // Make the call as of a time of its clock.
  void call_back(std::int64_t now);
  std::vector<std::pair<std::int64_t, std::int64_t>> coming() const override;
  const Clock& clock() const { return *clock_; }
  // ROS time switches to another source, or jumps.
  void before_switch();
  void after_switch();
  void after_jump();

protected:
  std::function<void(const TimerInfo&)> callback_;
  std::int64_t period_;

private:
  TimerInfo begin_call(std::int64_t now);
  void make_call(const TimerInfo& info);
  Clock::SharedPtr clock_;
  std::int64_t next_, last_;
  std::optional<std::int64_t> left_of_period_;  // while the source switches
  bool cancelled_;
  std::function<void(std::size_t)> on_reset_;
};

using VoidCallbackType = std::function<void()>;
using TimerCallbackType = std::function<void(TimerBase&)>;
using TimerInfoCallbackType = std::function<void(const TimerInfo&)>;

template<class Callback>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)
  GenericTimer(Clock::SharedPtr clock, std::chrono::nanoseconds period, Callback&& callback, Context::SharedPtr context,
      bool autostart = true)
    : TimerBase(std::move(clock), period, std::move(context), autostart)
  {
    tick_as(rosspin::name_of(callback), period_);
    auto kept = std::make_shared<Callback>(std::move(callback));  // which may not be copyable
    if constexpr (std::is_invocable_v<Callback&>)
      callback_ = [kept](const TimerInfo&) { (*kept)(); };
    else if constexpr (std::is_invocable_v<Callback&, TimerBase&>)
      callback_ = [this, kept](const TimerInfo&) { (*kept)(*this); };
    else
      callback_ = [kept](const TimerInfo& info) { (*kept)(info); };
  }
};

template<class Callback>
class WallTimer : public GenericTimer<Callback>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)
  WallTimer(std::chrono::nanoseconds period, Callback&& callback, Context::SharedPtr context, bool autostart = true)
    : GenericTimer<Callback>(
          std::make_shared<Clock>(RCL_STEADY_TIME), period, std::move(callback), std::move(context), autostart)
  {
  }
};

// --- topics ---

class MessageInfo
{
public:
  MessageInfo() = default;
  explicit MessageInfo(const rmw_message_info_t& info) : info_(info) {}
  const rmw_message_info_t& get_rmw_message_info() const { return info_; }
  rmw_message_info_t& get_rmw_message_info() { return info_; }

private:
  rmw_message_info_t info_;
};

struct QOSEventInfo
{
  std::int32_t total_count = 0, total_count_change = 0, alive_count = 0, not_alive_count = 0, alive_count_change = 0,
               not_alive_count_change = 0, current_count = 0, current_count_change = 0;
  rmw_qos_policy_kind_t last_policy_kind = RMW_QOS_POLICY_INVALID;
};
using QOSDeadlineOfferedInfo = QOSEventInfo;
using QOSDeadlineRequestedInfo = QOSEventInfo;
using QOSLivelinessLostInfo = QOSEventInfo;
using QOSLivelinessChangedInfo = QOSEventInfo;
using QOSOfferedIncompatibleQoSInfo = QOSEventInfo;
using QOSRequestedIncompatibleQoSInfo = QOSEventInfo;
using QOSMessageLostInfo = QOSEventInfo;
struct MatchedInfo
{
  std::size_t total_count = 0, total_count_change = 0, current_count = 0;
  std::int32_t current_count_change = 0;
};
using PublisherMatchedInfo = MatchedInfo;
using SubscriptionMatchedInfo = MatchedInfo;

using QOSEventCallback = std::function<void(QOSEventInfo&)>;

// One that is told of ends that match.
struct MatchedCallback : QOSEventCallback
{
  MatchedCallback() = default;
  template<class Callback, std::enable_if_t<std::is_invocable_v<Callback&, MatchedInfo&>, int> = 0>
  MatchedCallback(Callback callback)
    : QOSEventCallback(
          [callback](QOSEventInfo& info) mutable
          {
            auto size = [](std::int32_t count) { return static_cast<std::size_t>(count); };
            MatchedInfo told{size(info.total_count), size(info.total_count_change), size(info.current_count),
                info.current_count_change};
            callback(told);
          })
  {
  }
};

// What publishers and subscriptions call, some of it never: nothing is lost, and Fast DDS does not tell of types.
struct EventCallbacks
{
  QOSEventCallback deadline_callback, liveliness_callback, incompatible_qos_callback, incompatible_type_callback,
      message_lost_callback;
  MatchedCallback matched_callback;
};
using PublisherEventCallbacks = EventCallbacks;
using SubscriptionEventCallbacks = EventCallbacks;

enum class IntraProcessSetting
{
  Enable,
  Disable,
  NodeDefault
};

struct QosOverridingOptions
{
  static QosOverridingOptions with_default_policies() { return {}; }
};

struct PublisherOptionsBase
{
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  EventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  CallbackGroup::SharedPtr callback_group;
  QosOverridingOptions qos_overriding_options;
  static int require_unique_network_flow_endpoints
      ROSSPIN_NOT_SIMULATED("rclcpp::PublisherOptions::require_unique_network_flow_endpoints");
};
template<class Allocator>
struct PublisherOptionsWithAllocator : PublisherOptionsBase
{
};
using PublisherOptions = PublisherOptionsWithAllocator<std::allocator<void>>;

struct SubscriptionOptionsBase
{
  EventCallbacks event_callbacks;
  bool use_default_callbacks = true, ignore_local_publications = false;
  CallbackGroup::SharedPtr callback_group;
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  QosOverridingOptions qos_overriding_options;
  static int require_unique_network_flow_endpoints
      ROSSPIN_NOT_SIMULATED("rclcpp::SubscriptionOptions::require_unique_network_flow_endpoints");
  static int content_filter_options ROSSPIN_NOT_SIMULATED("rclcpp::SubscriptionOptions::content_filter_options");
  static int topic_stats_options ROSSPIN_NOT_SIMULATED("rclcpp::SubscriptionOptions::topic_stats_options");
};
template<class Allocator>
struct SubscriptionOptionsWithAllocator : SubscriptionOptionsBase
{
};
using SubscriptionOptions = SubscriptionOptionsWithAllocator<std::allocator<void>>;

namespace detail
{
// Tells a callback what has happened to an end of a topic, once for all since the last call.
class Event : public Callable
{
public:
  explicit Event(QOSEventCallback callback) : Callable(event), callback_(std::move(callback)) {}
  bool is_due() const override { return when_ != rosspin::never; }
  std::int64_t due() const override { return when_; }
  void call_back() override;
  void happen(const rosspin::Value& info, std::int64_t when);

private:
  QOSEventCallback callback_;
  QOSEventInfo info_;
  std::int64_t when_ = rosspin::never;
};

// The events of an end, by their names; `otherwise` is called for what does not match, if there is no callback.
class Events
{
public:
  Events(const EventCallbacks& callbacks, const QOSEventCallback& otherwise, const CallbackGroup::SharedPtr& group);
  std::vector<rosspin::Value> names() const;
  void happen(const std::string& name, const rosspin::Value& info, std::int64_t when);

private:
  std::vector<std::pair<std::string, std::shared_ptr<Event>>> all_;
};
}  // namespace detail

class PublisherBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(PublisherBase)
  PublisherBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic, const char* type,
      const QoS& qos, const PublisherOptionsBase& options);
  virtual ~PublisherBase();
  RCLCPP_DISABLE_COPY(PublisherBase)
  const char* get_topic_name() const { return topic_.c_str(); }
  std::size_t get_queue_size() const { return qos_.depth(); }
  std::size_t get_subscription_count() const;
  std::size_t get_intra_process_subscription_count() const;
  QoS get_actual_qos() const { return qos_; }
  bool can_loan_messages() const { return can_loan_; }
  bool assert_liveliness() const;
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_all_acked(std::chrono::duration<Rep, Period> = std::chrono::duration<Rep, Period>(-1)) const
  {
    return true;
  }

  // What follows is not rclcpp's.
  detail::Events& events() { return events_; }

protected:
  void send(const std::string& bytes);
  // The same of a message that a subscription in this process may be given as it is; else it is dropped.
  void send(const std::string& bytes, void* message, void (*drop)(void*));
  bool can_loan_ = false;

private:
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string topic_;
  QoS qos_;
  CallbackGroup::SharedPtr group_;  // kept, as the options are
  bool is_intra_process_;
  const char* type_;
  detail::Events events_;
  std::int64_t id_;
};

// A message that the middleware could have lent: here it is the publisher's own.
template<class M, class Allocator = std::allocator<void>>
class LoanedMessage
{
public:
  LoanedMessage(const PublisherBase& publisher, std::allocator<M>) : can_loan_(publisher.can_loan_messages())
  {
    if (!can_loan_)
      RCLCPP_INFO_ONCE(
          get_logger("rclcpp"), "Currently used middleware can't loan messages. Local allocator will be used.");
  }
  bool is_valid() const { return message_ != nullptr; }
  M& get() const { return *message_; }
  std::unique_ptr<M> release() { return std::move(message_); }

private:
  bool can_loan_;
  std::unique_ptr<M> message_ = std::make_unique<M>();
};

template<class M, class Allocator = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher)
  using ROSMessageType = M;
  using PublishedType = M;
  template<class Options>
  Publisher(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic, const char* type,
      const QoS& qos, const Options& options)
    : PublisherBase(std::move(node), topic, type, qos, options)
  {
    // Fast DDS lends messages that are in memory as they are sent.
    can_loan_ = std::is_trivially_copyable_v<M>;
  }
  LoanedMessage<M, Allocator> borrow_loaned_message() { return {*this, std::allocator<M>()}; }
  void publish(LoanedMessage<M, Allocator>&& message)
  {
    if (!message.is_valid())
      throw std::runtime_error("loaned message is not valid");
    publish(message.release());
  }
  virtual void publish(const M& message) { send(detail::serialized(message)); }
  template<class T>
  std::enable_if_t<std::is_same_v<T, M>> publish(const T& message)
  {
    publish(message);
  }
  virtual void publish(std::unique_ptr<M> message)
  {
    if (!message)
      throw std::runtime_error("cannot publish msg which is a null pointer");
    std::string bytes = detail::serialized(*message);
    send(bytes, message.release(), [](void* from) { delete static_cast<M*>(from); });
  }
};

class SubscriptionBase : public detail::Callable
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(SubscriptionBase)
  SubscriptionBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic, const char* type,
      const QoS& qos, const SubscriptionOptionsBase& options);
  ~SubscriptionBase() override;
  RCLCPP_DISABLE_COPY(SubscriptionBase)
  const char* get_topic_name() const { return topic_.c_str(); }
  std::size_t get_publisher_count() const;
  QoS get_actual_qos() const { return qos_; }
  bool is_serialized() const { return false; }

  // What follows is not rclcpp's. A message as it comes.
  struct Received
  {
    std::string bytes;
    MessageInfo info;
    std::int64_t when = 0;  // in the run's time
  };
  bool is_due() const override { return !received_.empty(); }
  std::int64_t due() const override { return received_.empty() ? rosspin::never : received_.front().when; }
  void receive(Received received);
  detail::Events& events() { return events_; }
  // Call back when a message comes, whoever spins.
  void take_immediately();

protected:
  bool take_one(Received& received);
  // Return a message that came as it is, for the caller to keep; null if none did with these bytes.
  void* take_moved(const std::string& bytes);

private:
  friend PublisherBase;
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string topic_;
  const char* type_;
  QoS qos_;
  CallbackGroup::SharedPtr group_;  // kept, as the options are
  bool is_intra_process_;
  detail::Events events_;
  std::int64_t id_;
  bool at_once_ = false;
  std::deque<Received> received_;
};

namespace detail
{
template<class>
constexpr bool no = false;

// Call a callback of a subscription with a message in the form that it takes.
template<class M, class Callback, class... More>
void call_with(Callback& callback, std::unique_ptr<M> message, const More&... more)
{
  if constexpr (std::is_invocable_v<Callback&, std::shared_ptr<M const>, const More&...>)
    callback(std::shared_ptr<M const>(std::move(message)), more...);
  else if constexpr (std::is_invocable_v<Callback&, std::shared_ptr<M>, const More&...>)
    callback(std::shared_ptr<M>(std::move(message)), more...);
  else if constexpr (std::is_invocable_v<Callback&, std::unique_ptr<M>, const More&...>)
    callback(std::move(message), more...);
  else if constexpr (std::is_invocable_v<Callback&, const M&, const More&...>)
    callback(static_cast<const M&>(*message), more...);
  else if constexpr (sizeof...(More) == 0)
    static_assert(no<Callback>, "a callback of a subscription takes a message: const M&, or a shared or unique pointer");
}

template<class M, class Callback, class... More>
constexpr bool takes = std::is_invocable_v<Callback&, std::shared_ptr<M const>, const More&...> ||
                       std::is_invocable_v<Callback&, std::shared_ptr<M>, const More&...> ||
                       std::is_invocable_v<Callback&, std::unique_ptr<M>, const More&...> ||
                       std::is_invocable_v<Callback&, const M&, const More&...>;
}  // namespace detail

template<class M, class Allocator = std::allocator<void>>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription)
  using ROSMessageType = M;
  using SubscribedType = M;
  template<class Callback>
  Subscription(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic, const QoS& qos,
      Callback&& callback, const SubscriptionOptionsBase& options)
    : SubscriptionBase(std::move(node), topic, M::rosspin_type, qos, options)
  {
    typedef std::decay_t<Callback> Kept;
    if constexpr (!detail::takes<M, Kept> && detail::takes<M, Kept, MessageInfo>)
      callback_ = [kept = Kept(std::forward<Callback>(callback))](std::unique_ptr<M> message, const MessageInfo& info)
                      mutable { detail::call_with<M>(kept, std::move(message), info); };
    else
      callback_ = [kept = Kept(std::forward<Callback>(callback))](std::unique_ptr<M> message, const MessageInfo&)
                      mutable { detail::call_with<M>(kept, std::move(message)); };
  }
  void call_back() override
  {
    Received received;
    if (!take_one(received))
      return;
    std::unique_ptr<M> message(static_cast<M*>(take_moved(received.bytes)));
    if (!message)
    {
      message = std::make_unique<M>();
      detail::deserialize(received.bytes, *message);
    }
    callback_(std::move(message), received.info);
  }
  // Make the call for a message that was taken otherwise.
  void handle_message(std::shared_ptr<void>& message, const MessageInfo& info)
  {
    callback_(std::make_unique<M>(*static_cast<M*>(message.get())), info);
  }
  bool take(M& message, MessageInfo& info)
  {
    rosspin::spins();
    Received received;
    if (!take_one(received))
      return false;
    detail::deserialize(received.bytes, message);
    info = received.info;
    return true;
  }

private:
  std::function<void(std::unique_ptr<M>, const MessageInfo&)> callback_;
};

// --- services ---

class ServiceBase : public detail::Callable
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServiceBase)
  ServiceBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, const char* type,
      const QoS& qos);
  ~ServiceBase() override;
  RCLCPP_DISABLE_COPY(ServiceBase)
  const char* get_service_name() const { return name_.c_str(); }

  // What follows is not rclcpp's.
  struct Request
  {
    std::int64_t number;
    std::string bytes;
    std::int64_t when = 0;  // in the run's time
  };
  bool is_due() const override { return !requests_.empty(); }
  std::int64_t due() const override { return requests_.empty() ? rosspin::never : requests_.front().when; }
  void receive(Request request) { requests_.push_back(std::move(request)); }

protected:
  bool take_one(Request& request);
  void send(const rmw_request_id_t& header, const std::string& bytes);

private:
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string name_;
  std::int64_t id_;
  std::deque<Request> requests_;
};

template<class S>
class Service : public ServiceBase, public std::enable_shared_from_this<Service<S>>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Service)
  typedef std::shared_ptr<typename S::Request> SharedRequest;
  typedef std::shared_ptr<typename S::Response> SharedResponse;
  typedef std::shared_ptr<rmw_request_id_t> Header;

  template<class Callback>
  Service(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, Callback&& callback,
      const QoS& qos)
    : ServiceBase(std::move(node), name, S::rosspin_type, qos)
  {
    typedef std::decay_t<Callback> Kept;
    callback_ = [this, kept = Kept(std::forward<Callback>(callback))](
                    Header header, SharedRequest request, SharedResponse response) mutable
    {
      if constexpr (std::is_invocable_v<Kept&, SharedRequest, SharedResponse>)
        kept(std::move(request), response);
      else if constexpr (std::is_invocable_v<Kept&, Header, SharedRequest, SharedResponse>)
        kept(header, std::move(request), response);
      else if constexpr (std::is_invocable_v<Kept&, Header, SharedRequest>)
        return kept(header, std::move(request)), false;
      else if constexpr (std::is_invocable_v<Kept&, std::shared_ptr<Service>, Header, SharedRequest>)
        return kept(this->shared_from_this(), header, std::move(request)), false;
      else
        static_assert(detail::no<Kept>, "a callback of a service takes a shared request and a shared response");
      return true;
    };
  }
  void call_back() override
  {
    Request taken;
    if (!take_one(taken))
      return;
    auto request = std::make_shared<typename S::Request>();
    detail::deserialize(taken.bytes, *request);
    auto response = std::make_shared<typename S::Response>();
    auto header = std::make_shared<rmw_request_id_t>();
    header->sequence_number = taken.number;
    if (callback_(header, request, response))
      send_response(*header, *response);
  }
  void send_response(rmw_request_id_t& header, typename S::Response& response)
  {
    send(header, detail::serialized(response));
  }

private:
  std::function<bool(Header, SharedRequest, SharedResponse)> callback_;
};

class ClientBase : public detail::Callable
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientBase)
  ClientBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, const char* type,
      const QoS& qos);
  ~ClientBase() override;
  RCLCPP_DISABLE_COPY(ClientBase)
  const char* get_service_name() const { return name_.c_str(); }
  bool service_is_ready() const;
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_service(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait_for_service_nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }

  // What follows is not rclcpp's.
  struct Answer
  {
    std::int64_t sequence;
    std::string bytes;
    std::int64_t when = 0;  // in the run's time
  };
  bool is_due() const override { return !answers_.empty(); }
  std::int64_t due() const override { return answers_.empty() ? rosspin::never : answers_.front().when; }
  void receive(Answer answer) { answers_.push_back(std::move(answer)); }

protected:
  bool wait_for_service_nanoseconds(std::chrono::nanoseconds timeout);
  bool take_one(Answer& answer);
  std::int64_t send(const std::string& bytes);

private:
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  std::string name_;
  std::int64_t id_;
  std::deque<Answer> answers_;
};

namespace detail
{
template<class Future>
struct FutureAndRequestId
{
  Future future;
  std::int64_t request_id;
  FutureAndRequestId(Future future, std::int64_t id) : future(std::move(future)), request_id(id) {}
  operator Future&() { return future; }
  auto get() { return future.get(); }
  bool valid() const noexcept { return future.valid(); }
  void wait() const { future.wait(); }
  template<class Rep, class Period>
  std::future_status wait_for(const std::chrono::duration<Rep, Period>& length) const
  {
    return future.wait_for(length);
  }
  template<class Clock, class Duration>
  std::future_status wait_until(const std::chrono::time_point<Clock, Duration>& time) const
  {
    return future.wait_until(time);
  }
};
}  // namespace detail

template<class S>
class Client : public ClientBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Client)
  using Request = typename S::Request;
  using Response = typename S::Response;
  using SharedRequest = std::shared_ptr<Request>;
  using SharedResponse = std::shared_ptr<Response>;
  using Promise = std::promise<SharedResponse>;
  using PromiseWithRequest = std::promise<std::pair<SharedRequest, SharedResponse>>;
  using SharedPromise = std::shared_ptr<Promise>;
  using SharedPromiseWithRequest = std::shared_ptr<PromiseWithRequest>;
  using Future = std::future<SharedResponse>;
  using SharedFuture = std::shared_future<SharedResponse>;
  using SharedFutureWithRequest = std::shared_future<std::pair<SharedRequest, SharedResponse>>;
  using CallbackType = std::function<void(SharedFuture)>;
  using CallbackWithRequestType = std::function<void(SharedFutureWithRequest)>;

  struct FutureAndRequestId : detail::FutureAndRequestId<Future>
  {
    using detail::FutureAndRequestId<Future>::FutureAndRequestId;
    operator SharedFuture() { return this->future.share(); }
    SharedFuture share() noexcept { return this->future.share(); }
  };
  struct SharedFutureAndRequestId : detail::FutureAndRequestId<SharedFuture>
  {
    using detail::FutureAndRequestId<SharedFuture>::FutureAndRequestId;
  };
  struct SharedFutureWithRequestAndRequestId : detail::FutureAndRequestId<SharedFutureWithRequest>
  {
    using detail::FutureAndRequestId<SharedFutureWithRequest>::FutureAndRequestId;
  };

  Client(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, const QoS& qos)
    : ClientBase(std::move(node), name, S::rosspin_type, qos)
  {
  }

  FutureAndRequestId async_send_request(SharedRequest request)
  {
    auto promise = std::make_shared<Promise>();
    std::int64_t id = ask(*request, [promise](SharedResponse response) { promise->set_value(response); });
    return FutureAndRequestId(promise->get_future(), id);
  }
  template<class Callback, std::enable_if_t<std::is_invocable_v<Callback&, SharedFuture>, int> = 0>
  SharedFutureAndRequestId async_send_request(SharedRequest request, Callback&& callback)
  {
    auto promise = std::make_shared<Promise>();
    SharedFuture future = promise->get_future().share();
    std::int64_t id = ask(*request,
        [promise, future, callback = CallbackType(std::forward<Callback>(callback))](SharedResponse response)
        {
          promise->set_value(response);
          callback(future);
        });
    return SharedFutureAndRequestId(future, id);
  }
  template<class Callback,
      std::enable_if_t<!std::is_invocable_v<Callback&, SharedFuture> &&
                           std::is_invocable_v<Callback&, SharedFutureWithRequest>,
          int> = 0>
  SharedFutureWithRequestAndRequestId async_send_request(SharedRequest request, Callback&& callback)
  {
    auto promise = std::make_shared<PromiseWithRequest>();
    SharedFutureWithRequest future = promise->get_future().share();
    std::int64_t id = ask(*request,
        [promise, future, request, callback = CallbackWithRequestType(std::forward<Callback>(callback))](
            SharedResponse response)
        {
          promise->set_value({request, response});
          callback(future);
        });
    return SharedFutureWithRequestAndRequestId(future, id);
  }
  bool remove_pending_request(std::int64_t id) { return pending_.erase(id) != 0; }
  template<class Asked>
  bool remove_pending_request(const Asked& asked)
  {
    return remove_pending_request(asked.request_id);
  }
  std::size_t prune_pending_requests()
  {
    std::size_t size = pending_.size();
    pending_.clear();
    return size;
  }
  template<class Allocator = std::allocator<std::int64_t>>
  std::size_t prune_requests_older_than(
      std::chrono::time_point<std::chrono::system_clock> time, std::vector<std::int64_t, Allocator>* pruned = nullptr)
  {
    std::size_t size = pending_.size();
    for (auto each = pending_.begin(); each != pending_.end();)
    {
      bool is_older = each->second.first < time;
      if (is_older && pruned)
        pruned->push_back(each->first);
      each = is_older ? pending_.erase(each) : std::next(each);
    }
    return size - pending_.size();
  }
  void call_back() override
  {
    Answer answer;
    if (!take_one(answer))
      return;
    auto found = pending_.find(answer.sequence);
    if (found == pending_.end())
      return;
    auto settle = std::move(found->second.second);
    pending_.erase(found);
    auto response = std::make_shared<Response>();
    detail::deserialize(answer.bytes, *response);
    settle(response);
  }

private:
  std::int64_t ask(const Request& request, std::function<void(SharedResponse)> settle)
  {
    std::int64_t id = send(detail::serialized(request));
    pending_[id] = {std::chrono::system_clock::now(), std::move(settle)};
    return id;
  }
  // When each was sent, and what to do with its response.
  std::map<std::int64_t,
      std::pair<std::chrono::time_point<std::chrono::system_clock>, std::function<void(SharedResponse)>>>
      pending_;
};
}  // namespace rclcpp

#endif
