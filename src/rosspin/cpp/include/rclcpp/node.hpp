// The node of rclcpp.
#ifndef ROSSPIN_RCLCPP_NODE_HPP
#define ROSSPIN_RCLCPP_NODE_HPP

#include <list>
#include <optional>
#include <set>

#include "rclcpp/entities.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp
{
class NodeOptions
{
public:
#define ROSSPIN_OPTION(type, name, start)                                                                              \
  NodeOptions& name(const type& value)                                                                                 \
  {                                                                                                                    \
    name##_ = value;                                                                                                   \
    return *this;                                                                                                      \
  }                                                                                                                    \
  const type& name() const { return name##_; }                                                                         \
  type name##_ = start;
  ROSSPIN_OPTION(Context::SharedPtr, context, contexts::get_global_default_context())
  ROSSPIN_OPTION(std::vector<std::string>, arguments, {})
  ROSSPIN_OPTION(std::vector<Parameter>, parameter_overrides, {})
  ROSSPIN_OPTION(bool, use_global_arguments, true)
  ROSSPIN_OPTION(bool, enable_rosout, true)
  ROSSPIN_OPTION(bool, use_intra_process_comms, false)
  ROSSPIN_OPTION(bool, enable_topic_statistics, false)
  ROSSPIN_OPTION(bool, start_parameter_services, true)
  ROSSPIN_OPTION(bool, enable_logger_service, false)
  ROSSPIN_OPTION(bool, start_parameter_event_publisher, true)
  ROSSPIN_OPTION(rcl_clock_type_t, clock_type, RCL_ROS_TIME)
  ROSSPIN_OPTION(QoS, clock_qos, ClockQoS())
  ROSSPIN_OPTION(bool, use_clock_thread, true)
  ROSSPIN_OPTION(QoS, parameter_event_qos, ParameterEventsQoS())
  ROSSPIN_OPTION(QoS, rosout_qos, RosoutQoS())
  ROSSPIN_OPTION(bool, allow_undeclared_parameters, false)
  ROSSPIN_OPTION(bool, automatically_declare_parameters_from_overrides, false)
#undef ROSSPIN_OPTION
  std::vector<Parameter>& parameter_overrides() { return parameter_overrides_; }
  template<class T>
  NodeOptions& append_parameter_override(const std::string& name, const T& value)
  {
    parameter_overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }
};

namespace node_interfaces
{
struct PreSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PreSetParametersCallbackHandle)
  std::function<void(std::vector<Parameter>&)> callback;
};
struct OnSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  using OnSetParametersCallbackType =
      std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter>&)>;
  OnSetParametersCallbackType callback;
};
struct PostSetParametersCallbackHandle
{
  RCLCPP_SMART_PTR_DEFINITIONS(PostSetParametersCallbackHandle)
  std::function<void(const std::vector<Parameter>&)> callback;
};

// The parameters of a node (source: node_interfaces/node_parameters.cpp).
class NodeParametersInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeParametersInterface)
  typedef rcl_interfaces::msg::ParameterDescriptor Descriptor;
  typedef rcl_interfaces::msg::SetParametersResult Result;
  using PreSetParametersCallbackType = std::function<void(std::vector<Parameter>&)>;
  using OnSetParametersCallbackType = OnSetParametersCallbackHandle::OnSetParametersCallbackType;
  using PostSetParametersCallbackType = std::function<void(const std::vector<Parameter>&)>;

  NodeParametersInterface(NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock, const NodeOptions& options);
  const ParameterValue& declare_parameter(const std::string& name, const ParameterValue& default_value,
      const Descriptor& descriptor = Descriptor(), bool ignore_override = false);
  const ParameterValue& declare_parameter(const std::string& name, ParameterType type,
      const Descriptor& descriptor = Descriptor(), bool ignore_override = false);
  void undeclare_parameter(const std::string& name);
  bool has_parameter(const std::string& name) const { return all_.count(name) != 0; }
  std::vector<Result> set_parameters(const std::vector<Parameter>& parameters);
  Result set_parameters_atomically(const std::vector<Parameter>& parameters);
  std::vector<Parameter> get_parameters(const std::vector<std::string>& names) const;
  Parameter get_parameter(const std::string& name) const;
  bool get_parameter(const std::string& name, Parameter& parameter) const;
  bool get_parameters_by_prefix(const std::string& prefix, std::map<std::string, Parameter>& parameters) const;
  std::vector<Descriptor> describe_parameters(const std::vector<std::string>& names) const;
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string>& names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(
      const std::vector<std::string>& prefixes, std::uint64_t depth) const;
  const std::map<std::string, ParameterValue>& get_parameter_overrides() const { return overrides_; }

  template<class Handle, class Callback>
  static typename Handle::SharedPtr add(std::list<std::weak_ptr<Handle>>& all, Callback callback)
  {
    auto handle = std::make_shared<Handle>();
    handle->callback = std::move(callback);
    all.push_front(handle);  // the newest is called first
    return handle;
  }
  template<class Handle>
  static void remove(std::list<std::weak_ptr<Handle>>& all, const Handle* handle, const char* what)
  {
    for (auto each = all.begin(); each != all.end(); each++)
      if (each->lock().get() == handle)
      {
        all.erase(each);
        return;
      }
    throw std::runtime_error(std::string(what) + " set parameter callback doesn't exist");
  }
  std::list<std::weak_ptr<PreSetParametersCallbackHandle>> before;
  std::list<std::weak_ptr<OnSetParametersCallbackHandle>> on;
  std::list<std::weak_ptr<PostSetParametersCallbackHandle>> after;
  std::function<void(bool)> on_use_sim_time;  // called with its value when that is set

private:
  struct Info
  {
    ParameterValue value;
    Descriptor descriptor;
  };
  typedef std::map<std::string, Info> Infos;
  struct Changing;
  // Offer a service; what is not declared gives an empty answer.
  template<class S, class Answer>
  void offer(const char* name, Answer answer);
  void offer_all();
  void publish(rcl_interfaces::msg::ParameterEvent event) const;
  const ParameterValue& declare(const std::string& name, ParameterType type, const ParameterValue& default_value,
      Descriptor descriptor, bool ignore_override);
  Result start(const std::string& name, const ParameterValue& default_value, const Descriptor& descriptor, Infos& into,
      bool with_callbacks, bool ignore_override);
  Result set(const std::vector<Parameter>& parameters, Infos& infos, bool with_callbacks, bool allow_undeclared);
  NodeBaseInterface::SharedPtr node_;
  Clock::SharedPtr clock_;
  std::vector<std::shared_ptr<ServiceBase>> services_;
  Infos all_;
  std::map<std::string, ParameterValue> overrides_;
  bool allow_undeclared_, tells_, changing_ = false;
};
}  // namespace node_interfaces

namespace node_interfaces
{
class NodeTimersInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTimersInterface)
  explicit NodeTimersInterface(NodeBaseInterface::SharedPtr node) : node_(std::move(node)) {}
  void add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr group)
  {
    node_->group_for(group, "timer")->add(timer);
  }

private:
  NodeBaseInterface::SharedPtr node_;
};
class NodeClockInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeClockInterface)
  explicit NodeClockInterface(Clock::SharedPtr clock) : clock_(std::move(clock)) {}
  Clock::SharedPtr get_clock() const { return clock_; }

private:
  Clock::SharedPtr clock_;
};
class NodeLoggingInterface
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeLoggingInterface)
  explicit NodeLoggingInterface(const std::string& name) : logger_(rclcpp::get_logger(name)) {}
  Logger get_logger() const { return logger_; }
  const char* get_logger_name() const { return logger_.get_name(); }

private:
  Logger logger_;
};
}  // namespace node_interfaces

using node_interfaces::OnSetParametersCallbackHandle;
using node_interfaces::PostSetParametersCallbackHandle;
using node_interfaces::PreSetParametersCallbackHandle;

namespace detail
{
// Sets a node's clock by /clock if its parameter use_sim_time asks for that (source: time_source.cpp).
class TimeSource
{
public:
  TimeSource(node_interfaces::NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock, const QoS& qos)
    : node_(std::move(node)), clock_(std::move(clock)), qos_(qos)
  {
  }
  void follow(bool active);

private:
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  Clock::SharedPtr clock_;
  QoS qos_;
  std::shared_ptr<SubscriptionBase> subscription_;
  std::shared_ptr<std::int64_t> last_ = std::make_shared<std::int64_t>(0);  // what /clock has told (ns)
};

std::chrono::nanoseconds checked_period(long double ns);
template<class Rep, class Period>
std::chrono::nanoseconds period_of(std::chrono::duration<Rep, Period> period)
{
  typedef std::chrono::duration<long double, std::nano> Wide;
  checked_period(std::chrono::duration_cast<Wide>(period).count());
  return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
}

std::string below(const std::string& name, const std::string& sub_namespace);
}  // namespace detail

enum class EndpointType
{
  Invalid,
  Publisher,
  Subscription
};

class TopicEndpointInfo
{
public:
  std::string node_name_, node_namespace_, topic_type_;
  EndpointType endpoint_type_;
  QoS qos_profile_;
  EndpointType endpoint_type() const { return endpoint_type_; }
  const QoS& qos_profile() const { return qos_profile_; }
  QoS& qos_profile() { return qos_profile_; }
  const std::string& node_name() const { return node_name_; }
  const std::string& node_namespace() const { return node_namespace_; }
  const std::string& topic_type() const { return topic_type_; }
};

// Whether the graph has changed since it was made, or cleared.
class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  Event() = default;
  Event(const std::function<rosspin::Value()>& graph, const rosspin::Value& seen) : graph_(graph), seen_(seen) {}
  bool set() { return std::exchange(state_, true); }
  bool check();
  bool check_and_clear()
  {
    check();
    return std::exchange(state_, false);
  }

private:
  std::function<rosspin::Value()> graph_;
  rosspin::Value seen_;
  bool state_ = false;
};

class Node : public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)
  explicit Node(const std::string& name, const NodeOptions& options = NodeOptions()) : Node(name, "", options) {}
  explicit Node(const std::string& name, const std::string& ns, const NodeOptions& options = NodeOptions());
  virtual ~Node() = default;
  RCLCPP_DISABLE_COPY(Node)

  const char* get_name() const { return base_->get_name(); }
  const char* get_namespace() const { return base_->get_namespace(); }
  const char* get_fully_qualified_name() const { return base_->get_fully_qualified_name(); }
  Logger get_logger() const { return rclcpp::get_logger(base_->logger_name()); }
  const NodeOptions& get_node_options() const { return options_; }
  const std::string& get_sub_namespace() const { return sub_namespace_; }
  std::string get_effective_namespace() const
  {
    std::string around = get_namespace();
    return sub_namespace_.empty() ? around : (around == "/" ? around : around + "/") + sub_namespace_;
  }
  SharedPtr create_sub_node(const std::string& sub_namespace)
  {
    return std::shared_ptr<Node>(new Node(*this, sub_namespace, 0));
  }
  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatic = true)
  {
    return base_->create_callback_group(type, automatic);
  }
  void for_each_callback_group(const node_interfaces::NodeBaseInterface::CallbackGroupFunction& function)
  {
    base_->for_each_callback_group(function);
  }
  Clock::SharedPtr get_clock() { return clock_; }
  Clock::ConstSharedPtr get_clock() const { return clock_; }
  Time now() const { return clock_->now(); }

  // --- timers ---

  template<class Rep = std::int64_t, class Period = std::milli, class Callback>
  typename WallTimer<Callback>::SharedPtr create_wall_timer(std::chrono::duration<Rep, Period> period,
      Callback callback, CallbackGroup::SharedPtr group = nullptr, bool autostart = true)
  {
    auto timer = std::make_shared<WallTimer<Callback>>(
        detail::period_of(period), std::move(callback), base_->get_context(), autostart);
    base_->group_for(group, "timer")->add(timer);
    return timer;
  }
  template<class Rep = std::int64_t, class Period = std::milli, class Callback>
  typename GenericTimer<Callback>::SharedPtr create_timer(std::chrono::duration<Rep, Period> period, Callback callback,
      CallbackGroup::SharedPtr group = nullptr)
  {
    auto timer = std::make_shared<GenericTimer<Callback>>(
        clock_, detail::period_of(period), std::move(callback), base_->get_context());
    base_->group_for(group, "timer")->add(timer);
    return timer;
  }

  // --- topics ---

  template<class M, class Allocator = std::allocator<void>, class Made = Publisher<M, Allocator>>
  std::shared_ptr<Made> create_publisher(const std::string& topic, const QoS& qos,
      const PublisherOptionsWithAllocator<Allocator>& options = PublisherOptionsWithAllocator<Allocator>())
  {
    return std::make_shared<Made>(base_, detail::below(topic, sub_namespace_), M::rosspin_type, qos, options);
  }
  template<class M, class Callback, class Allocator = std::allocator<void>>
  std::shared_ptr<Subscription<M, Allocator>> create_subscription(const std::string& topic, const QoS& qos,
      Callback&& callback,
      const SubscriptionOptionsWithAllocator<Allocator>& options = SubscriptionOptionsWithAllocator<Allocator>())
  {
    auto group = base_->group_for(options.callback_group, "subscription");
    auto made = std::make_shared<Subscription<M, Allocator>>(
        base_, detail::below(topic, sub_namespace_), qos, std::forward<Callback>(callback), options);
    group->add(made);
    return made;
  }
  template<class... Arguments>
  std::shared_ptr<void> create_generic_publisher(const Arguments&...)
      ROSSPIN_NOT_SIMULATED("rclcpp::Node::create_generic_publisher");
  template<class... Arguments>
  std::shared_ptr<void> create_generic_subscription(const Arguments&...)
      ROSSPIN_NOT_SIMULATED("rclcpp::Node::create_generic_subscription");

  // --- services ---

  template<class S>
  typename Client<S>::SharedPtr create_client(
      const std::string& name, const QoS& qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    auto in = base_->group_for(group, "client");
    auto made = std::make_shared<Client<S>>(base_, detail::below(name, sub_namespace_), qos);
    in->add(made);
    return made;
  }
  template<class S>
  typename Client<S>::SharedPtr create_client(
      const std::string& name, const rmw_qos_profile_t& qos, CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<S>(name, QoS(QoSInitialization::from_rmw(qos), qos), group);
  }
  template<class S, class Callback>
  typename Service<S>::SharedPtr create_service(const std::string& name, Callback&& callback,
      const QoS& qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    auto in = base_->group_for(group, "service");
    auto made = std::make_shared<Service<S>>(
        base_, detail::below(name, sub_namespace_), std::forward<Callback>(callback), qos);
    in->add(made);
    return made;
  }
  template<class S, class Callback>
  typename Service<S>::SharedPtr create_service(const std::string& name, Callback&& callback,
      const rmw_qos_profile_t& qos, CallbackGroup::SharedPtr group = nullptr)
  {
    return create_service<S>(
        name, std::forward<Callback>(callback), QoS(QoSInitialization::from_rmw(qos), qos), group);
  }

  // --- parameters ---

  typedef rcl_interfaces::msg::ParameterDescriptor Descriptor;
  const ParameterValue& declare_parameter(const std::string& name, const ParameterValue& default_value,
      const Descriptor& descriptor = Descriptor(), bool ignore_override = false)
  {
    return parameters_->declare_parameter(detail::below(name, sub_namespace_), default_value, descriptor,
        ignore_override);
  }
  const ParameterValue& declare_parameter(const std::string& name, ParameterType type,
      const Descriptor& descriptor = Descriptor{}, bool ignore_override = false)
  {
    return parameters_->declare_parameter(detail::below(name, sub_namespace_), type, descriptor, ignore_override);
  }
  template<class T>
  auto declare_parameter(const std::string& name, const T& default_value, const Descriptor& descriptor = Descriptor(),
      bool ignore_override = false)
  {
    typedef std::conditional_t<std::is_convertible_v<T, std::string>, std::string, T> Value;
    try
    {
      return detail::converted<Value>(
          declare_parameter(name, ParameterValue(default_value), descriptor, ignore_override).template get<Value>());
    }
    catch (const ParameterTypeException& error)
    {
      throw exceptions::InvalidParameterTypeException(name, error.what());
    }
  }
  template<class T>
  auto declare_parameter(
      const std::string& name, const Descriptor& descriptor = Descriptor(), bool ignore_override = false)
  {
    ParameterValue value{T{}};
    try
    {
      return detail::converted<T>(
          declare_parameter(name, value.get_type(), descriptor, ignore_override).template get<T>());
    }
    catch (const ParameterTypeException&)
    {
      throw exceptions::UninitializedStaticallyTypedParameterException(name);
    }
  }
  template<class T>
  std::vector<T> declare_parameters(
      const std::string& ns, const std::map<std::string, T>& parameters, bool ignore_overrides = false)
  {
    std::vector<T> values;
    for (const auto& [name, value] : parameters)
      values.push_back(
          declare_parameter(ns.empty() ? name : ns + "." + name, value, Descriptor(), ignore_overrides));
    return values;
  }
  template<class T>
  std::vector<T> declare_parameters(const std::string& ns,
      const std::map<std::string, std::pair<T, Descriptor>>& parameters, bool ignore_overrides = false)
  {
    std::vector<T> values;
    for (const auto& [name, given] : parameters)
      values.push_back(
          declare_parameter(ns.empty() ? name : ns + "." + name, given.first, given.second, ignore_overrides));
    return values;
  }
  void undeclare_parameter(const std::string& name) { parameters_->undeclare_parameter(name); }
  bool has_parameter(const std::string& name) const { return parameters_->has_parameter(name); }
  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter& parameter)
  {
    return set_parameters_atomically({parameter});
  }
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<Parameter>& parameters)
  {
    return parameters_->set_parameters(parameters);
  }
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(const std::vector<Parameter>& parameters)
  {
    return parameters_->set_parameters_atomically(parameters);
  }
  Parameter get_parameter(const std::string& name) const { return parameters_->get_parameter(name); }
  bool get_parameter(const std::string& name, Parameter& parameter) const
  {
    return parameters_->get_parameter(name, parameter);
  }
  template<class T>
  bool get_parameter(const std::string& name, T& value) const
  {
    Parameter parameter;
    if (!get_parameter(detail::below(name, sub_namespace_), parameter))
      return false;
    value = parameter.get_value<T>();
    return true;
  }
  template<class T>
  bool get_parameter_or(const std::string& name, T& value, const T& otherwise) const
  {
    if (get_parameter(name, value))
      return true;
    value = otherwise;
    return false;
  }
  template<class T>
  T get_parameter_or(const std::string& name, const T& otherwise) const
  {
    T value;
    get_parameter_or(name, value, otherwise);
    return value;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string>& names) const
  {
    return parameters_->get_parameters(names);
  }
  template<class T>
  bool get_parameters(const std::string& prefix, std::map<std::string, T>& values) const
  {
    std::map<std::string, Parameter> found;
    bool any = parameters_->get_parameters_by_prefix(prefix, found);
    for (const auto& [name, parameter] : found)
      values[name] = parameter.get_value<T>();
    return any;
  }
  Descriptor describe_parameter(const std::string& name) const { return describe_parameters({name}).front(); }
  std::vector<Descriptor> describe_parameters(const std::vector<std::string>& names) const
  {
    return parameters_->describe_parameters(names);
  }
  std::vector<std::uint8_t> get_parameter_types(const std::vector<std::string>& names) const
  {
    return parameters_->get_parameter_types(names);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(
      const std::vector<std::string>& prefixes, std::uint64_t depth) const
  {
    return parameters_->list_parameters(prefixes, depth);
  }
  using PreSetParametersCallbackHandle = node_interfaces::PreSetParametersCallbackHandle;
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using PostSetParametersCallbackHandle = node_interfaces::PostSetParametersCallbackHandle;
  using PreSetParametersCallbackType = node_interfaces::NodeParametersInterface::PreSetParametersCallbackType;
  using OnSetParametersCallbackType = node_interfaces::NodeParametersInterface::OnSetParametersCallbackType;
  using OnParametersSetCallbackType = OnSetParametersCallbackType;
  using PostSetParametersCallbackType = node_interfaces::NodeParametersInterface::PostSetParametersCallbackType;
  PreSetParametersCallbackHandle::SharedPtr add_pre_set_parameters_callback(PreSetParametersCallbackType callback)
  {
    return parameters_->add(parameters_->before, std::move(callback));
  }
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(OnSetParametersCallbackType callback)
  {
    return parameters_->add(parameters_->on, std::move(callback));
  }
  PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(PostSetParametersCallbackType callback)
  {
    return parameters_->add(parameters_->after, std::move(callback));
  }
  void remove_pre_set_parameters_callback(const PreSetParametersCallbackHandle* handle)
  {
    parameters_->remove(parameters_->before, handle, "Pre");
  }
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle* handle)
  {
    parameters_->remove(parameters_->on, handle, "On");
  }
  void remove_post_set_parameters_callback(const PostSetParametersCallbackHandle* handle)
  {
    parameters_->remove(parameters_->after, handle, "Post");
  }

  // --- the graph ---

  std::vector<std::string> get_node_names() const;
  std::map<std::string, std::vector<std::string>> get_topic_names_and_types() const;
  std::map<std::string, std::vector<std::string>> get_service_names_and_types() const;
  std::map<std::string, std::vector<std::string>> get_service_names_and_types_by_node(
      const std::string& name, const std::string& ns) const;
  std::size_t count_publishers(const std::string& topic) const;
  std::size_t count_subscribers(const std::string& topic) const;
  std::size_t count_clients(const std::string& service) const;
  std::size_t count_services(const std::string& service) const;
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(const std::string& topic, bool no_mangle = false) const;
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(
      const std::string& topic, bool no_mangle = false) const;

  Event::SharedPtr get_graph_event();
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout);

  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() { return base_; }
  node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface() { return parameters_; }
  node_interfaces::NodeTimersInterface::SharedPtr get_node_timers_interface()
  {
    return std::make_shared<node_interfaces::NodeTimersInterface>(base_);
  }
  node_interfaces::NodeClockInterface::SharedPtr get_node_clock_interface()
  {
    return std::make_shared<node_interfaces::NodeClockInterface>(clock_);
  }
  node_interfaces::NodeLoggingInterface::SharedPtr get_node_logging_interface()
  {
    return std::make_shared<node_interfaces::NodeLoggingInterface>(base_->logger_name());
  }

private:
  Node(const Node& other, const std::string& sub_namespace, int);
  NodeOptions options_;
  std::string sub_namespace_;
  std::vector<Event::WeakPtr> graph_events_;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  Clock::SharedPtr clock_;
  node_interfaces::NodeParametersInterface::SharedPtr parameters_;
  std::shared_ptr<detail::TimeSource> time_source_;
};

// Has other clocks than the node's own follow /clock, if the node does.
class TimeSource
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)
  explicit TimeSource(std::shared_ptr<Node> node) : node_(std::move(node)) {}
  void attachClock(Clock::SharedPtr clock)
  {
    sources_.emplace_back(node_->get_node_base_interface(), std::move(clock), ClockQoS());
    sources_.back().follow(node_->get_parameter("use_sim_time").as_bool());
  }

private:
  std::shared_ptr<Node> node_;
  std::list<detail::TimeSource> sources_;
};

// --- the same as functions ---

template<class M, class AnyNode>
auto create_publisher(AnyNode&& node, const std::string& topic, const QoS& qos,
    const PublisherOptions& options = PublisherOptions())
{
  return node->template create_publisher<M>(topic, qos, options);
}
template<class M, class Callback, class AnyNode>
auto create_subscription(AnyNode&& node, const std::string& topic, const QoS& qos, Callback&& callback,
    const SubscriptionOptions& options = SubscriptionOptions())
{
  return node->template create_subscription<M>(topic, qos, std::forward<Callback>(callback), options);
}
template<class Callback>
typename TimerBase::SharedPtr create_timer(node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeTimersInterface::SharedPtr timers, Clock::SharedPtr clock, Duration period, Callback&& callback,
    CallbackGroup::SharedPtr group = nullptr)
{
  typedef std::decay_t<Callback> Kept;
  auto timer = std::make_shared<GenericTimer<Kept>>(std::move(clock),
      detail::period_of(std::chrono::nanoseconds(period.nanoseconds())), Kept(std::forward<Callback>(callback)),
      base->get_context());
  timers->add_timer(timer, group);
  return timer;
}
template<class AnyNode, class Callback>
typename TimerBase::SharedPtr create_timer(AnyNode node, Clock::SharedPtr clock, Duration period, Callback&& callback,
    CallbackGroup::SharedPtr group = nullptr)
{
  return create_timer(node->get_node_base_interface(), node->get_node_timers_interface(), std::move(clock), period,
      std::forward<Callback>(callback), std::move(group));
}
template<class Rep, class Period, class Callback>
typename WallTimer<Callback>::SharedPtr create_wall_timer(std::chrono::duration<Rep, Period> period, Callback callback,
    CallbackGroup::SharedPtr group, node_interfaces::NodeBaseInterface* base,
    node_interfaces::NodeTimersInterface* timers, bool autostart = true)
{
  if (!base || !timers)
    throw std::invalid_argument(base ? "input node_timers cannot be null" : "input node_base cannot be null");
  auto timer = std::make_shared<WallTimer<Callback>>(
      detail::period_of(period), std::move(callback), base->get_context(), autostart);
  timers->add_timer(timer, group);
  return timer;
}

// --- what is not simulated ---

class ROSSPIN_NOT_SIMULATED("rclcpp::GenericPublisher") GenericPublisher;
class ROSSPIN_NOT_SIMULATED("rclcpp::GenericSubscription") GenericSubscription;
class ROSSPIN_NOT_SIMULATED("rclcpp::SerializedMessage") SerializedMessage;
class ROSSPIN_NOT_SIMULATED("rclcpp::NetworkFlowEndpoint") NetworkFlowEndpoint;
}  // namespace rclcpp

#endif
