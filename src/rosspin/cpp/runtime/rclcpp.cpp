// What is no template of the stand-in for rclcpp.
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace rclcpp
{
namespace
{
constexpr std::int64_t second = 1'000'000'000;

// How long a call takes of a timer that is always due.
constexpr std::int64_t least_period = 1'000, least_call = 20'000;

std::int64_t later(std::int64_t time, std::int64_t by)
{
  return by > rosspin::never - time ? rosspin::never : time + by;
}

const rosspin::Value& field(const rosspin::Value& table, const char* name)
{
  static const rosspin::Value none;
  auto found = table.fields.find(name);
  return found == table.fields.end() ? none : found->second;
}

// Raise what the host has answered with, if that is an error.
void check(const rosspin::Value& answer, const std::string& failed)
{
  const std::string& error = field(answer, "error").string;
  const std::string& text = field(answer, "text").string;
  if (error == "node name")
    throw exceptions::InvalidNodeNameError(text);
  if (error == "namespace")
    throw exceptions::InvalidNamespaceError(text);
  if (error == "topic name")
    throw exceptions::InvalidTopicNameError(text);
  if (error == "service name")
    throw exceptions::InvalidServiceNameError(text);
  if (error == "arguments")
    throw exceptions::RCLInvalidROSArgsError(text);
  if (error == "unknown arguments")
  {
    std::vector<std::string> words;
    for (const rosspin::Value& word : field(answer, "words").items)
      words.push_back(word.string);
    throw exceptions::UnknownROSArgsError(words);
  }
  bool begins = text.rfind("Failed to create ", 0) == 0;  // with rclpy's own words
  if (!error.empty())
    throw exceptions::RCLError(failed + ": " + (begins ? text.substr(text.find(": ") + 2) : text));
}

std::vector<rosspin::Value> values_of(const std::vector<std::string>& words)
{
  return {words.begin(), words.end()};
}

rosspin::Value bytes_of(const std::string& bytes)
{
  rosspin::Value value;
  value.kind = rosspin::Value::bytes;
  value.string = bytes;
  return value;
}

// What the host knows by numbers.
template<class T>
std::map<std::int64_t, T*>& all()
{
  static auto* known = new std::map<std::int64_t, T*>;
  return *known;
}
}  // namespace

// --- time (sources: time.cpp, duration.cpp, clock.cpp, rate.cpp) ---

namespace detail
{
std::int64_t sum(std::int64_t one, std::int64_t other, const char* what)
{
  std::int64_t result;
  if (!__builtin_add_overflow(one, other, &result))
    return result;
  if (one > 0)
    throw std::overflow_error(std::string(what) + " leads to int64_t overflow");
  throw std::underflow_error(std::string(what) + " leads to int64_t underflow");
}

std::int64_t difference(std::int64_t one, std::int64_t other, const char* what)
{
  std::int64_t result;
  if (!__builtin_sub_overflow(one, other, &result))
    return result;
  if (one > 0)
    throw std::overflow_error(std::string(what) + " leads to int64_t overflow");
  throw std::underflow_error(std::string(what) + " leads to int64_t underflow");
}
}  // namespace detail

Duration::operator builtin_interfaces::msg::Duration() const
{
  builtin_interfaces::msg::Duration message;
  std::int64_t whole = ns_ / second - (ns_ % second < 0);
  bool fits = whole >= INT32_MIN && whole <= INT32_MAX;
  message.sec = fits ? static_cast<std::int32_t>(whole) : whole > 0 ? INT32_MAX : INT32_MIN;
  message.nanosec = fits ? static_cast<std::uint32_t>(ns_ - whole * second) : whole > 0 ? UINT32_MAX : 0;
  return message;
}

Duration Duration::operator*(double scale) const
{
  if (!std::isfinite(scale))
    throw std::runtime_error("abnormal scale in rclcpp::Duration");
  long double scaled = static_cast<long double>(ns_) * scale;
  if (scaled > static_cast<long double>(INT64_MAX))
    throw std::overflow_error("duration scaling leads to int64_t overflow");
  if (scaled < static_cast<long double>(INT64_MIN))
    throw std::underflow_error("duration scaling leads to int64_t underflow");
  return from_nanoseconds(static_cast<std::int64_t>(scaled));
}

rmw_time_t Duration::to_rmw_time() const
{
  if (ns_ < 0)
    throw std::runtime_error("rmw_time_t cannot be negative");
  return {static_cast<std::uint64_t>(ns_ / second), static_cast<std::uint64_t>(ns_ % second)};
}

Time::Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock_type)
  : ns_(seconds * second + nanoseconds), type_(clock_type)
{
  if (seconds < 0)
    throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
}

Time::operator builtin_interfaces::msg::Time() const
{
  builtin_interfaces::msg::Time message;
  std::int64_t whole = ns_ / second - (ns_ % second < 0);
  message.sec = static_cast<std::int32_t>(whole);
  message.nanosec = static_cast<std::uint32_t>(ns_ - whole * second);
  return message;
}

const Time& Time::compared(const Time& other) const
{
  if (type_ != other.type_)
    throw std::runtime_error("can't compare times with different time sources");
  return *this;
}

Duration Time::operator-(const Time& other) const
{
  if (type_ != other.type_)
    throw std::runtime_error("can't subtract times with different time sources [" + std::to_string(type_) +
                             " != " + std::to_string(other.type_) + "]");
  return Duration::from_nanoseconds(detail::difference(ns_, other.ns_, "time subtraction"));
}

std::int64_t Clock::ns() const
{
  if (type_ == RCL_STEADY_TIME)
    return rosspin::now();
  if (active_)
  {
    rosspin::look();
    return ros_;
  }
  return rosspin::system_now();
}

std::int64_t Clock::in_run(std::int64_t ns) const
{
  if (active_)
    return ns <= ros_ ? rosspin::detail::time() : rosspin::never;
  return type_ == RCL_STEADY_TIME ? ns : ns - rosspin::detail::ahead();
}

// Source: rcl/time.c, rcl_clock_call_callbacks. A threshold of 0 is none.
void Clock::tell(const rcl_time_jump_t& jump, bool before)
{
  std::int64_t delta = jump.delta.nanoseconds;
  for (const auto& each : std::vector<std::weak_ptr<JumpHandler>>(handlers_))
    if (auto handler = each.lock())
    {
      const auto& notice = handler->notice_threshold;
      std::int64_t forward = notice.min_forward.nanoseconds, backward = notice.min_backward.nanoseconds;
      if (!(jump.clock_change != RCL_ROS_TIME_NO_CHANGE && notice.on_clock_change) &&
          !(forward && delta >= forward) && !(backward && delta <= backward))
        continue;
      if (before && handler->pre_callback)
        handler->pre_callback();
      if (!before && handler->post_callback)
        handler->post_callback(jump);
    }
}

void Clock::follow(bool active)
{
  if (active == active_ || type_ != RCL_ROS_TIME)
    return;
  rcl_time_jump_t jump{active ? RCL_ROS_TIME_ACTIVATED : RCL_ROS_TIME_DEACTIVATED, {0}};
  tell(jump, true);
  for (TimerBase* timer : timers)
    timer->before_switch();
  switched_ = true;
  active_ = active;
  for (TimerBase* timer : timers)
    timer->after_switch();
  tell(jump, false);
  rosspin::stir();
}

void Clock::set(std::int64_t ns)
{
  rcl_time_jump_t jump{RCL_ROS_TIME_NO_CHANGE, {ns - ros_}};
  if (active_)
    tell(jump, true);
  ros_ = ns;
  if (!active_ || !jump.delta.nanoseconds)
    return;
  for (TimerBase* timer : timers)
    timer->after_jump();
  tell(jump, false);
  rosspin::stir();
}

JumpHandler::SharedPtr Clock::create_jump_callback(
    JumpHandler::pre_callback_t before, JumpHandler::post_callback_t after, const rcl_jump_threshold_t& threshold)
{
  if (threshold.min_forward.nanoseconds < 0)
    throw exceptions::RCLInvalidArgument(
        "Failed to add time jump callback: forward jump threshold must be positive or zero");
  if (threshold.min_backward.nanoseconds > 0)
    throw exceptions::RCLInvalidArgument(
        "Failed to add time jump callback: backward jump threshold must be negative or zero");
  auto handler = std::make_shared<JumpHandler>(JumpHandler{std::move(before), std::move(after), threshold});
  handlers_.push_back(handler);
  return handler;
}

bool Clock::sleep_until(Time until, Context::SharedPtr context)
{
  if (!context || !context->is_valid())
    throw std::runtime_error("context cannot be slept with because it's invalid");
  if (until.get_clock_type() != type_)
    throw std::runtime_error("until's clock type does not match this clock's type");
  switched_ = false;
  rosspin::look();
  while (ns() < until.nanoseconds() && !cancelled_ && !switched_ && context->is_valid())
    rosspin::wait(in_run(until.nanoseconds()));
  cancelled_ = false;
  return context->is_valid() && !switched_ && ns() >= until.nanoseconds();
}

bool Clock::wait_until_started(Context::SharedPtr context)
{
  if (!context || !context->is_valid())
    throw std::runtime_error("context cannot be slept with because it's invalid");
  return started() || sleep_until(Time(0, 1, type_), context);
}

bool Clock::wait_until_started(const Duration& timeout, Context::SharedPtr context, const Duration&)
{
  if (!context || !context->is_valid())
    throw std::runtime_error("context cannot be slept with because it's invalid");
  std::int64_t end = later(rosspin::now(), timeout.nanoseconds());
  while (!started() && context->is_valid() && rosspin::now() < end)
    rosspin::wait(end);
  return started();
}

Rate::Rate(double rate, Clock::SharedPtr clock) : clock_(std::move(clock))
{
  if (rate <= 0.0)
    throw std::invalid_argument("rate must be greater than 0");
  period_ = Duration::from_seconds(1.0 / rate).nanoseconds();
  reset();
}

Rate::Rate(const Duration& period, Clock::SharedPtr clock) : clock_(std::move(clock))
{
  if (period <= Duration(0, 0))
    throw std::invalid_argument("period must be greater than 0");
  period_ = period.nanoseconds();
  reset();
}

bool Rate::sleep()
{
  std::int64_t now = time(), length = end_pass("Rate", now) - now;
  if (length > 0)
    clock_->sleep_for(Duration::from_nanoseconds(length));
  begin_pass();
  return length > 0;
}

// A sleep ends one period after the mark, and moves the mark there. If that has passed, it does not sleep; and if a whole
// period more has passed, the mark is set one period ahead of now (source: rate.cpp, Rate::sleep).
std::int64_t Rate::wake(std::int64_t& mark, std::int64_t now) const
{
  std::int64_t next = std::max(now, now < mark ? now + period_ : mark + period_);
  mark += period_;
  if (now > mark + period_)
    mark = now + period_;
  return next;
}

// --- logging (sources: rcutils/logging.c, logging_macros.h) ---

namespace
{
struct Logs
{
  std::map<std::string, int> levels;
  int level = RCUTILS_LOG_SEVERITY_INFO;
  bool console = true, coloured = false, on_rosout = false;
  std::string form = "[{severity}] [{time}] [{name}]: {message}";
  int stream = 2;
};

Logs& logs()
{
  static Logs* one = new Logs;
  return *one;
}

std::string stamp(std::int64_t ns)
{
  char text[40];
  std::snprintf(text, sizeof text, "%lld.%09lld", static_cast<long long>(ns / second),
      static_cast<long long>(ns % second));
  return text;
}

const char* name_of_level(int severity)
{
  return severity >= 50 ? "FATAL" : severity >= 40 ? "ERROR" : severity >= 30 ? "WARN" : severity >= 20 ? "INFO" : "DEBUG";
}
}  // namespace

namespace detail
{
bool logs(int severity, const char* name)
{
  return severity >= rcutils_logging_get_logger_effective_level(name);
}

namespace
{
void print(const Logs& own, int severity, const char* name, const Place& place, const std::string& text)
{
  std::int64_t now = rosspin::system_now();
  std::map<std::string, std::string> fields = {{"severity", name_of_level(severity)}, {"time", stamp(now)},
      {"name", name}, {"message", text}, {"function_name", place.function}, {"file_name", place.file},
      {"line_number", std::to_string(place.line)}, {"time_as_nanoseconds", std::to_string(now)}};
  std::string line;
  for (std::size_t at = 0; at < own.form.size();)
  {
    std::size_t end = own.form[at] == '{' ? own.form.find('}', at) : std::string::npos;
    auto found = end == std::string::npos ? fields.end() : fields.find(own.form.substr(at + 1, end - at - 1));
    if (found == fields.end())
    {
      line += own.form[at++];
      continue;
    }
    line += found->second;
    at = end + 1;
  }
  if (own.coloured)
    line = std::string(severity >= 40 ? "\033[31m" : severity >= 30 ? "\033[33m" : severity >= 20 ? "\033[0m" : "\033[32m") +
           line + "\033[0m";
  rosspin::write(own.stream, line + "\n");
}
}  // namespace

void log(int severity, const char* name, const Place& place, const std::string& text)
{
  const Logs& own = rclcpp::logs();
  if (own.console)
    print(own, severity, name, place, text);
  if (own.on_rosout)
    rosspin::tell("log", {severity, name, text, place.file, place.function, place.line});
}
}  // namespace detail

Logger Logger::get_child(const std::string& suffix) const
{
  if (logs().on_rosout)
    rosspin::tell("child_logger", {name_, suffix});
  return Logger(name_ + "." + suffix);
}

std::filesystem::path get_logging_directory()
{
  const char* directory = std::getenv("ROS_LOG_DIR");
  const char* home = std::getenv("HOME");
  return directory ? directory : std::string(home ? home : "") + "/.ros/log";
}

// --- contexts (sources: context.cpp, utilities.cpp, signal_handler.cpp) ---

namespace
{
std::vector<std::weak_ptr<Context>>& contexts_of_process()
{
  static auto* all = new std::vector<std::weak_ptr<Context>>;
  return *all;
}

SignalHandlerOptions handled = SignalHandlerOptions::None;

void at_signal(int number)
{
  RCLCPP_INFO(get_logger("rclcpp"), "signal_handler(signum=%d)", number);
  for (const auto& context : get_contexts())
    if (context->get_init_options().shutdown_on_signal)
      context->shutdown("signal handler");
}

void received(const std::string& what, std::int64_t when, const rosspin::Value& values)
{
  auto find = [&](auto& all) { return all.find(values.items[0].whole); };
  if (what == "message")
  {
    if (auto found = find(all<SubscriptionBase>()); found != all<SubscriptionBase>().end())
    {
      rmw_message_info_t info;
      info.source_timestamp = values.items[2].whole;
      info.received_timestamp = values.items[3].whole;
      info.publication_sequence_number = info.reception_sequence_number = values.items[4].whole;
      found->second->receive({values.items[1].string, MessageInfo(info), when});
    }
  }
  else if (what == "happened")
  {
    auto tell = [&](auto& all)
    {
      if (auto found = all.find(values.items[1].whole); found != all.end())
        found->second->events().happen(values.items[2].string, values.items[3], when);
    };
    if (values.items[0].flag)
      tell(all<PublisherBase>());
    else
      tell(all<SubscriptionBase>());
  }
  else if (what == "request")
  {
    if (auto found = find(all<ServiceBase>()); found != all<ServiceBase>().end())
      found->second->receive({values.items[1].whole, values.items[2].string, when});
  }
  else if (what == "response")
  {
    if (auto found = find(all<ClientBase>()); found != all<ClientBase>().end())
      found->second->receive({values.items[1].whole, values.items[2].string, when});
  }
}
}  // namespace

std::vector<Context::SharedPtr> get_contexts()
{
  std::vector<Context::SharedPtr> found;
  for (const auto& each : contexts_of_process())
    if (auto context = each.lock(); context && context->is_valid())
      found.push_back(context);
  return found;
}

void Context::init(int argc, char const* const* argv, const InitOptions& options)
{
  if (valid_)
    throw ContextAlreadyInitialized();
  std::vector<std::string> words(argv, argv + argc);
  rosspin::on_event = received;
  rosspin::Value answer = rosspin::ask("init", {values_of(words), options.auto_initialize_logging()});
  rclcpp::check(answer, "failed to initialize rcl");
  id_ = field(answer, "id").whole;
  options_ = options;
  valid_ = true;
  reason_.clear();
  contexts_of_process().push_back(weak_from_this());
  if (!options.auto_initialize_logging())
    return;
  Logs& own = logs();
  own.level = static_cast<int>(field(answer, "level").whole);
  own.console = field(answer, "console").flag;
  own.on_rosout = field(answer, "rosout").flag;
  own.coloured = field(answer, "coloured").flag;
  own.form = field(answer, "form").string;
  own.stream = field(answer, "to_stdout").flag ? 1 : 2;
  for (const auto& [name, level] : field(answer, "levels").fields)
    own.levels[name] = static_cast<int>(level.whole);
}

bool Context::shutdown(const std::string& reason)
{
  if (!valid_)
    return false;
  for (const auto& callback : Callbacks(before_))
    (*callback)();
  valid_ = false;
  reason_ = reason;
  logs().on_rosout = false;
  rosspin::tell("shutdown", {id_});
  rosspin::stir();
  for (const auto& callback : Callbacks(after_))
    (*callback)();
  return true;
}

ShutdownCallbackHandle Context::add(Callbacks& all, OnShutdownCallback callback)
{
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  all.push_back(kept);
  return {kept};
}

bool Context::remove(Callbacks& all, const ShutdownCallbackHandle& handle)
{
  std::size_t before = all.size();
  all.remove(handle.callback.lock());
  return all.size() < before;
}

bool Context::sleep_for(const std::chrono::nanoseconds& length)
{
  std::int64_t end = later(rosspin::now(), length.count());
  rosspin::look();
  bool was_valid = valid_;
  while (rosspin::now() < end && valid_ == was_valid)
    rosspin::wait(end);
  return valid_;
}

void Context::check(const char* what) const
{
  if (id_ < 0)
    throw exceptions::RCLInvalidArgument(std::string(what) + ": context argument is null");
  if (!valid_)
    throw exceptions::RCLError(std::string(what) + ": the given context is not valid, either rcl_init() was not called "
                                                   "or rcl_shutdown() was called.");
}

namespace contexts
{
Context::SharedPtr get_global_default_context()
{
  static auto* one = new Context::SharedPtr(std::make_shared<DefaultContext>());
  return *one;
}
}  // namespace contexts

void init(int argc, char const* const* argv, const InitOptions& options, SignalHandlerOptions signals)
{
  contexts::get_global_default_context()->init(argc, argv, options);
  install_signal_handlers(signals);
}

std::vector<std::string> init_and_remove_ros_arguments(int argc, char const* const* argv, const InitOptions& options)
{
  init(argc, argv, options);
  return remove_ros_arguments(argc, argv);
}

std::vector<std::string> remove_ros_arguments(int argc, char const* const* argv)
{
  std::vector<std::string> kept;
  bool ros = false;
  for (int each = 0; each < argc; each++)
  {
    std::string word = argv[each];
    if (word == "--ros-args" || (ros && word == "--"))
      ros = word == "--ros-args";
    else if (!ros)
      kept.push_back(word);
  }
  return kept;
}

bool install_signal_handlers(SignalHandlerOptions options)
{
  if (handled != SignalHandlerOptions::None || options == SignalHandlerOptions::None)
    return false;
  handled = options;
  if (options != SignalHandlerOptions::SigTerm)
    std::signal(SIGINT, at_signal);
  if (options != SignalHandlerOptions::SigInt)
    std::signal(SIGTERM, at_signal);
  return true;
}

bool signal_handlers_installed() { return handled != SignalHandlerOptions::None; }
SignalHandlerOptions get_current_signal_handler_options() { return handled; }

bool uninstall_signal_handlers()
{
  if (handled == SignalHandlerOptions::None)
    return false;
  if (handled != SignalHandlerOptions::SigTerm)
    std::signal(SIGINT, SIG_DFL);
  if (handled != SignalHandlerOptions::SigInt)
    std::signal(SIGTERM, SIG_DFL);
  handled = SignalHandlerOptions::None;
  return true;
}

namespace
{
Context::SharedPtr or_default(Context::SharedPtr context)
{
  return context ? context : contexts::get_global_default_context();
}
}  // namespace

bool ok(Context::SharedPtr context)
{
  rosspin::look();
  return or_default(context)->is_valid();
}

bool shutdown(Context::SharedPtr context, const std::string& reason)
{
  bool done = or_default(context)->shutdown(reason);
  if (or_default(context) == contexts::get_global_default_context())
    uninstall_signal_handlers();
  return done;
}

void on_shutdown(std::function<void()> callback, Context::SharedPtr context)
{
  or_default(context)->on_shutdown(std::move(callback));
}

bool sleep_for(const std::chrono::nanoseconds& length, Context::SharedPtr context)
{
  return or_default(context)->sleep_for(length);
}

// --- nodes (sources: node_base.cpp, node.cpp, callback_group.cpp) ---

namespace detail
{
std::uint64_t changes = 1;

Callable::~Callable() { changed(); }

void changed()
{
  changes++;
  rosspin::stir();
}

std::chrono::nanoseconds checked_period(long double ns)
{
  if (ns < 0)
    throw std::invalid_argument("timer period cannot be negative");
  if (ns > static_cast<long double>(INT64_MAX))
    throw std::invalid_argument("timer period must be less than std::chrono::nanoseconds::max()");
  return std::chrono::nanoseconds(static_cast<std::int64_t>(ns));
}

std::string below(const std::string& name, const std::string& sub_namespace)
{
  return sub_namespace.empty() || name[0] == '/' || name[0] == '~' ? name : sub_namespace + "/" + name;
}
}  // namespace detail

CallbackGroup::~CallbackGroup()
{
  *free_ = true;
  if (!members().empty())
    rosspin::lose("group");
}

void CallbackGroup::add(const std::shared_ptr<detail::Callable>& member)
{
  member->group = weak_from_this();
  member->free = free_;
  members_.push_back(member);
  detail::changed();
}

std::vector<std::shared_ptr<detail::Callable>> CallbackGroup::members() const
{
  std::vector<std::shared_ptr<detail::Callable>> found;
  for (const auto& each : members_)
    if (auto member = each.lock())
      found.push_back(member);
  members_.assign(found.begin(), found.end());
  return found;
}

namespace node_interfaces
{
NodeBaseInterface::NodeBaseInterface(const std::string& name, const std::string& ns, const NodeOptions& options)
  : context_(options.context()), is_intra_process_(options.use_intra_process_comms())
{
  context_->check("failed to create guard condition");
  rosspin::Value answer = rosspin::ask("node", {context_->id(), name, ns, values_of(options.arguments()),
                                                   options.use_global_arguments(), options.enable_rosout()});
  rclcpp::check(answer, "failed to initialize rcl node");
  id_ = field(answer, "id").whole;
  name_ = field(answer, "name").string;
  namespace_ = field(answer, "namespace").string;
  full_name_ = field(answer, "full name").string;
  logger_ = field(answer, "logger").string;
  overrides_ = field(answer, "overrides").fields;
  default_group_ = create_callback_group(CallbackGroupType::MutuallyExclusive);
}

NodeBaseInterface::~NodeBaseInterface()
{
  rosspin::tell("end_node", {id_});
  detail::changed();
}

CallbackGroup::SharedPtr NodeBaseInterface::create_callback_group(CallbackGroupType type, bool automatic)
{
  auto group = std::make_shared<CallbackGroup>(type, automatic);
  groups_.push_back(group);
  detail::changed();
  return group;
}

bool NodeBaseInterface::callback_group_in_node(CallbackGroup::SharedPtr group)
{
  for (const auto& each : groups_)
    if (each.lock() == group)
      return true;
  return false;
}

void NodeBaseInterface::for_each_callback_group(const CallbackGroupFunction& function)
{
  for (const auto& each : groups_)
    if (auto group = each.lock())
      function(group);
}

CallbackGroup::SharedPtr NodeBaseInterface::group_for(const CallbackGroup::SharedPtr& given, const char* what)
{
  if (!given)
    return default_group_;
  if (!callback_group_in_node(given))
    throw exceptions::MissingGroupNodeException(what);
  return given;
}

rosspin::Value NodeBaseInterface::ask(
    const std::string& what, std::vector<rosspin::Value> values, const char* failed) const
{
  values.insert(values.begin(), id_);
  rosspin::Value answer = rosspin::ask(what, std::move(values));
  rclcpp::check(answer, failed);
  return answer;
}

std::string NodeBaseInterface::resolve_topic_or_service_name(
    const std::string& name, bool is_service, bool only_expand) const
{
  return field(ask("resolve", {name, is_service, only_expand}, "failed to resolve name"), "name").string;
}
}  // namespace node_interfaces

namespace
{
rosspin::Value profile(const QoS& qos)
{
  const rmw_qos_profile_t& from = qos.get_rmw_qos_profile();
  auto ns = [](const rmw_time_t& time)
  { return time.sec > INT64_MAX / second ? INT64_MAX : static_cast<std::int64_t>(time.sec * second + time.nsec); };
  return std::map<std::string, rosspin::Value>{{"history", static_cast<int>(from.history)},
      {"depth", static_cast<std::int64_t>(from.depth)}, {"reliability", static_cast<int>(from.reliability)},
      {"durability", static_cast<int>(from.durability)}, {"deadline", ns(from.deadline)},
      {"lifespan", ns(from.lifespan)}, {"liveliness", static_cast<int>(from.liveliness)},
      {"liveliness_lease_duration", ns(from.liveliness_lease_duration)}};
}
}  // namespace

bool operator==(const QoS& one, const QoS& other) { return profile(one) == profile(other); }

std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t kind)
{
  static const std::map<rmw_qos_policy_kind_t, std::string> names = {{RMW_QOS_POLICY_DURABILITY, "DURABILITY"},
      {RMW_QOS_POLICY_DEADLINE, "DEADLINE"}, {RMW_QOS_POLICY_LIVELINESS, "LIVELINESS"},
      {RMW_QOS_POLICY_RELIABILITY, "RELIABILITY"}, {RMW_QOS_POLICY_HISTORY, "HISTORY"},
      {RMW_QOS_POLICY_LIFESPAN, "LIFESPAN"}};
  auto found = names.find(kind);
  return (found == names.end() ? "INVALID" : found->second) + "_QOS_POLICY";
}

// --- timers (source: rcl/timer.c) ---

TimerBase::TimerBase(Clock::SharedPtr clock, std::chrono::nanoseconds period, Context::SharedPtr context, bool autostart)
  : Callable(timer), period_(period.count()), clock_(std::move(clock)), cancelled_(!autostart)
{
  if (!context)
    context = contexts::get_global_default_context();
  context->check("Couldn't initialize rcl timer handle");
  last_ = clock_->ns();
  next_ = later(last_, period_);
  if (clock_->get_clock_type() == RCL_ROS_TIME)
    clock_->timers.push_back(this);
  rosspin::await_spin(autostart);
}

TimerBase::~TimerBase()
{
  if (!cancelled_)
    lose();
  auto& all = clock_->timers;
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
}

void TimerBase::cancel()
{
  rosspin::await_spin(-!cancelled_);
  cancelled_ = true;
}

void TimerBase::reset()
{
  rosspin::await_spin(cancelled_);
  next_ = later(clock_->ns(), period_);
  cancelled_ = false;
  rosspin::stir();
  if (on_reset_)
    on_reset_(1);
}

std::chrono::nanoseconds TimerBase::time_until_trigger() const
{
  return cancelled_ ? std::chrono::nanoseconds::max() : std::chrono::nanoseconds(next_ - clock_->ns());
}

// Source: _rcl_timer_time_jump. A time of 0 is not told yet; only in a run may the system's be 0, too.
void TimerBase::before_switch()
{
  if (std::int64_t now = clock_->ns(); now || !clock_->ros_time_is_active())
    left_of_period_ = next_ - now;
}

void TimerBase::after_switch()
{
  std::int64_t now = clock_->ns();
  if (!left_of_period_ || !(now || !clock_->ros_time_is_active()))
    return;
  last_ = now - *left_of_period_;
  next_ = last_ < 0 ? last_ + period_ : later(last_, period_);
  left_of_period_.reset();
}

void TimerBase::after_jump()
{
  std::int64_t now = clock_->ns();
  if (next_ <= now || now >= last_)
    return;
  last_ = now;
  next_ = later(now, period_);
}

// When a call begins, the next one is due one period after this one was. If that has passed, it is due at the next place
// on the grid (source: rcl_timer_call).
TimerInfo TimerBase::begin_call(std::int64_t now)
{
  std::int64_t expected = next_;
  last_ = now;
  next_ = later(next_, period_);
  if (period_ < least_period)
    next_ = now + least_call;
  else if (next_ <= now)
    next_ += (1 + (now - next_) / period_) * period_;
  return {Time(expected, clock_->get_clock_type()), Time(now, clock_->get_clock_type())};
}

void TimerBase::make_call(const TimerInfo& info)
{
  std::int64_t begun = rosspin::now(), ahead = clock_->ns() - begun;
  std::int64_t tick = begin_tick(info.expected_call_time.nanoseconds() - ahead, begun);
  callback_(info);
  end_tick(tick, rosspin::now() - begun);
}

void TimerBase::call_back(std::int64_t now)
{
  if (!cancelled_)
    make_call(begin_call(now));
}

std::vector<std::pair<std::int64_t, std::int64_t>> TimerBase::coming() const
{
  std::int64_t now = rosspin::now(), next = due();
  if (next == rosspin::never || period_ < least_period)
    return {};
  if (next > now)
    return {{next, next}};
  std::int64_t after = next + (1 + (now - next) / period_) * period_;
  return {{next, now}, {after, after}};
}

// --- topics and services ---

namespace detail
{
void Event::call_back()
{
  if (when_ == rosspin::never)
    return;
  QOSEventInfo told = info_;
  info_.total_count_change = info_.alive_count_change = info_.not_alive_count_change = info_.current_count_change = 0;
  when_ = rosspin::never;
  callback_(told);
}

void Event::happen(const rosspin::Value& info, std::int64_t when)
{
  auto take = [&](std::int32_t& count, std::int32_t& change, const std::string& name)
  {
    count = static_cast<std::int32_t>(field(info, (name + "_count").c_str()).whole);
    change += static_cast<std::int32_t>(field(info, (name + "_count_change").c_str()).whole);
  };
  take(info_.total_count, info_.total_count_change, "total");
  take(info_.current_count, info_.current_count_change, "current");
  take(info_.alive_count, info_.alive_count_change, "alive");
  take(info_.not_alive_count, info_.not_alive_count_change, "not_alive");
  if (auto policy = field(info, "last_policy_kind"); policy.kind == rosspin::Value::integer)
    info_.last_policy_kind = static_cast<rmw_qos_policy_kind_t>(policy.whole);
  when_ = std::min(when_, when);
}

Events::Events(
    const EventCallbacks& callbacks, const QOSEventCallback& otherwise, const CallbackGroup::SharedPtr& group)
{
  auto add = [&](const char* name, const QOSEventCallback& callback)
  {
    if (!callback)
      return;
    all_.emplace_back(name, std::make_shared<Event>(callback));
    group->add(all_.back().second);
  };
  add("deadline", callbacks.deadline_callback);
  add("liveliness", callbacks.liveliness_callback);
  add("incompatible_qos", callbacks.incompatible_qos_callback ? callbacks.incompatible_qos_callback : otherwise);
  add("matched", callbacks.matched_callback);
}

std::vector<rosspin::Value> Events::names() const
{
  std::vector<rosspin::Value> names;
  for (const auto& [name, event] : all_)
    names.push_back(name);
  return names;
}

void Events::happen(const std::string& name, const rosspin::Value& info, std::int64_t when)
{
  for (const auto& [each, event] : all_)
    if (each == name)
      event->happen(info, when);
}
}  // namespace detail

namespace
{
// What is said of what does not match, unless the node says that itself or wants nothing said.
template<class End>
QOSEventCallback logged(bool is_wanted, const End* end, const std::string& logger, const char* found, const char* then)
{
  if (!is_wanted)
    return nullptr;
  return [=](QOSEventInfo& info)
  {
    RCLCPP_WARN(get_logger(logger), "New %s incompatible QoS. No messages will be %s it. Last incompatible policy: %s",
        rosspin::formatted(found, {end->get_topic_name()}).c_str(), then,
        qos_policy_name_from_kind(info.last_policy_kind).c_str());
  };
}
}  // namespace

namespace
{
bool is_intra(IntraProcessSetting setting, const node_interfaces::NodeBaseInterface& node)
{
  return setting == IntraProcessSetting::Enable ||
         (setting == IntraProcessSetting::NodeDefault && node.get_use_intra_process_default());
}
}  // namespace

PublisherBase::PublisherBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic,
    const char* type, const QoS& qos, const PublisherOptionsBase& options)
  : node_(std::move(node)), qos_(qos), group_(options.callback_group),
    is_intra_process_(is_intra(options.use_intra_process_comm, *node_)), type_(type),
    events_(options.event_callbacks,
        logged(options.use_default_callbacks, this, node_->logger_name(),
            "subscription discovered on topic '%s', requesting", "sent to"),
        node_->group_for(options.callback_group, "publisher"))
{
  rosspin::Value answer =
      node_->ask("publisher", {topic, type, profile(qos), events_.names()}, "could not create publisher");
  id_ = field(answer, "id").whole;
  topic_ = field(answer, "name").string;
  all<PublisherBase>()[id_] = this;
}

PublisherBase::~PublisherBase()
{
  all<PublisherBase>().erase(id_);
  rosspin::tell("end_publisher", {id_});
}

std::size_t PublisherBase::get_subscription_count() const
{
  rosspin::look();
  return rosspin::ask("subscription_count", {id_}).whole;
}

bool PublisherBase::assert_liveliness() const
{
  rosspin::tell("assert_liveliness", {id_});
  return true;
}

void PublisherBase::send(const std::string& bytes)
{
  if (node_->get_context()->is_valid())
    rosspin::tell("publish", {id_, bytes_of(bytes)});
}

std::size_t PublisherBase::get_intra_process_subscription_count() const
{
  std::size_t count = 0;
  for (const auto& [id, each] : all<SubscriptionBase>())
    count += is_intra_process_ && each->is_intra_process_ && each->topic_ == topic_;
  return count;
}

namespace
{
// A message that goes to a subscription as it is, the oldest first, and what is sent of it meanwhile.
struct Moved
{
  const SubscriptionBase* to;
  std::string bytes;
  void* message;
  void (*drop)(void*);
  Moved* next;
};
Moved* moved = nullptr;

// Take one off; return its message.
void* unlinked(Moved** place)
{
  Moved* taken = *place;
  *place = taken->next;
  void* message = taken->message;
  delete taken;
  return message;
}

bool drop_oldest(const SubscriptionBase* to)
{
  for (Moved** place = &moved; *place; place = &(*place)->next)
    if ((*place)->to == to)
    {
      auto drop = (*place)->drop;
      drop(unlinked(place));
      return true;
    }
  return false;
}
}  // namespace

// Of several subscriptions in this process, the one made last is given it; the others are given copies.
void PublisherBase::send(const std::string& bytes, void* message, void (*drop)(void*))
{
  send(bytes);
  const SubscriptionBase* last = nullptr;
  for (const auto& [id, each] : all<SubscriptionBase>())
    if (is_intra_process_ && each->is_intra_process_ && each->topic_ == topic_ && each->type_ == type_)
      last = each;
  if (!last)
    return drop(message);
  std::size_t count = 0;
  Moved** end = &moved;
  for (; *end; end = &(*end)->next)
    count += (*end)->to == last;
  *end = new Moved{last, bytes, message, drop, nullptr};
  if (last->qos_.history() == HistoryPolicy::KeepLast && count > last->qos_.depth())
    drop_oldest(last);  // it will not come
}

SubscriptionBase::SubscriptionBase(node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& topic,
    const char* type, const QoS& qos, const SubscriptionOptionsBase& options)
  : Callable(subscription), node_(std::move(node)), type_(type), qos_(qos), group_(options.callback_group),
    is_intra_process_(is_intra(options.use_intra_process_comm, *node_)),
    events_(options.event_callbacks,
        logged(options.use_default_callbacks, this, node_->logger_name(),
            "publisher discovered on topic '%s', offering", "received from"),
        node_->group_for(options.callback_group, "subscription"))
{
  if (options.ignore_local_publications)
    rosspin::not_simulated("rclcpp::SubscriptionOptions::ignore_local_publications");
  rosspin::Value answer =
      node_->ask("subscription", {topic, type, profile(qos), events_.names()}, "could not create subscription");
  id_ = field(answer, "id").whole;
  topic_ = field(answer, "name").string;
  all<SubscriptionBase>()[id_] = this;
  rosspin::await_spin();
  rosspin::regain(topic_);
}

SubscriptionBase::~SubscriptionBase()
{
  auto& others = all<SubscriptionBase>();
  others.erase(id_);
  while (drop_oldest(this)) {}
  rosspin::tell("end_subscription", {id_});
  if (!at_once_)
    rosspin::lose(topic_);
  for (const auto& [id, other] : others)
    rosspin::regain(other->topic_);
}

void SubscriptionBase::take_immediately()
{
  at_once_ = true;
  rosspin::await_spin(-1);
}

std::size_t SubscriptionBase::get_publisher_count() const
{
  rosspin::look();
  return rosspin::ask("publisher_count", {id_}).whole;
}

void SubscriptionBase::receive(Received received)
{
  bool keeps_all = qos_.history() == HistoryPolicy::KeepAll;
  if (!keeps_all && received_.size() >= std::max<std::size_t>(qos_.depth(), 1))
    received_.pop_front();
  received_.push_back(std::move(received));
  if (at_once_)
    call_back();
}

bool SubscriptionBase::take_one(Received& received)
{
  if (received_.empty())
    return false;
  received = std::move(received_.front());
  received_.pop_front();
  return true;
}

void* SubscriptionBase::take_moved(const std::string& bytes)
{
  for (Moved** place = &moved; *place; place = &(*place)->next)
    if ((*place)->to == this && (*place)->bytes == bytes)
      return unlinked(place);
  return nullptr;
}

ServiceBase::ServiceBase(
    node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, const char* type, const QoS& qos)
  : Callable(service), node_(std::move(node))
{
  rosspin::Value answer = node_->ask("service", {name, type, profile(qos)}, "could not create service");
  id_ = field(answer, "id").whole;
  name_ = field(answer, "name").string;
  all<ServiceBase>()[id_] = this;
  rosspin::await_spin();
}

ServiceBase::~ServiceBase()
{
  all<ServiceBase>().erase(id_);
  rosspin::tell("end_service", {id_});
}

bool ServiceBase::take_one(Request& request)
{
  if (requests_.empty())
    return false;
  request = std::move(requests_.front());
  requests_.pop_front();
  return true;
}

void ServiceBase::send(const rmw_request_id_t& header, const std::string& bytes)
{
  rosspin::tell("respond", {id_, header.sequence_number, bytes_of(bytes)});
}

ClientBase::ClientBase(
    node_interfaces::NodeBaseInterface::SharedPtr node, const std::string& name, const char* type, const QoS& qos)
  : Callable(client), node_(std::move(node))
{
  rosspin::Value answer = node_->ask("client", {name, type, profile(qos)}, "could not create client");
  id_ = field(answer, "id").whole;
  name_ = field(answer, "name").string;
  all<ClientBase>()[id_] = this;
}

ClientBase::~ClientBase()
{
  all<ClientBase>().erase(id_);
  rosspin::tell("end_client", {id_});
}

bool ClientBase::service_is_ready() const
{
  rosspin::look();
  return node_->get_context()->is_valid() && rosspin::ask("service_is_ready", {id_}).flag;
}

// It looks when the graph changes, and every 0.1 s (source: client.cpp).
bool ClientBase::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout)
{
  std::int64_t end = timeout.count() < 0 ? rosspin::never : later(rosspin::now(), timeout.count());
  while (!service_is_ready())
  {
    if (rosspin::now() >= end || !node_->get_context()->is_valid())
      return false;
    rosspin::wait(std::min(end, rosspin::now() + 100'000'000));
  }
  return true;
}

bool ClientBase::take_one(Answer& answer)
{
  if (answers_.empty())
    return false;
  answer = std::move(answers_.front());
  answers_.pop_front();
  return true;
}

std::int64_t ClientBase::send(const std::string& bytes)
{
  static std::int64_t unsent = 0;
  if (!node_->get_context()->is_valid())
    return --unsent;  // rcl does not look, and no answer comes
  return rosspin::ask("send_request", {id_, bytes_of(bytes)}).whole;
}

// --- the node ---

namespace detail
{
// Source: time_source.cpp. The clock begins with the time that was told last, and 0 is what it tells when it is followed no
// more.
void TimeSource::follow(bool active)
{
  if (active == bool(subscription_))
    return;
  clock_->follow(active);
  clock_->set(active ? *last_ : 0);
  subscription_.reset();
  if (!active)
    return;
  // Its messages are taken as they come, whoever spins: rclcpp has a thread for that.
  auto take = [clock = clock_, last = last_](const rosgraph_msgs::msg::Clock& message)
  {
    *last = Time(message.clock).nanoseconds();
    clock->set(*last);
  };
  subscription_ = std::make_shared<Subscription<rosgraph_msgs::msg::Clock>>(
      node_, "/clock", qos_, take, SubscriptionOptionsBase());
  subscription_->take_immediately();
}
}  // namespace detail

Node::Node(const std::string& name, const std::string& ns, const NodeOptions& options)
  : options_(options), base_(std::make_shared<node_interfaces::NodeBaseInterface>(name, ns, options)),
    clock_(std::make_shared<Clock>(options.clock_type())),
    parameters_(std::make_shared<node_interfaces::NodeParametersInterface>(base_, clock_, options)),
    time_source_(std::make_shared<detail::TimeSource>(base_, clock_, options.clock_qos()))
{
  std::weak_ptr<detail::TimeSource> source = time_source_;
  parameters_->on_use_sim_time = [source](bool active)
  {
    if (auto held = source.lock())
      held->follow(active);
  };
  if (!has_parameter("use_sim_time"))
    parameters_->declare_parameter("use_sim_time", ParameterValue(false));
  if (parameters_->get_parameter("use_sim_time").as_bool())
    time_source_->follow(true);
  if (!has_parameter("start_type_description_service"))
    parameters_->declare_parameter("start_type_description_service", ParameterValue(true));
}

Node::Node(const Node& other, const std::string& sub_namespace, int)
  : options_(other.options_), sub_namespace_(detail::below(sub_namespace, other.sub_namespace_)), base_(other.base_),
    clock_(other.clock_), parameters_(other.parameters_), time_source_(other.time_source_)
{
}

namespace
{
std::vector<std::string> texts(const rosspin::Value& list)
{
  std::vector<std::string> found;
  for (const rosspin::Value& item : list.items)
    found.push_back(item.string);
  return found;
}

std::map<std::string, std::vector<std::string>> types(const rosspin::Value& answer)
{
  std::map<std::string, std::vector<std::string>> found;
  for (const auto& [name, list] : field(answer, "types").fields)
    found[name] = texts(list);
  return found;
}

std::vector<TopicEndpointInfo> infos(const rosspin::Value& answer)
{
  std::vector<TopicEndpointInfo> found;
  for (const rosspin::Value& each : field(answer, "infos").items)
  {
    const rosspin::Value& profile = each.items[4];
    auto number = [&](const char* name) { return field(profile, name).whole; };
    auto length = [&](const char* name) { return Duration::from_nanoseconds(number(name)); };
    QoS qos(static_cast<std::size_t>(number("depth")));
    qos.history(static_cast<HistoryPolicy>(number("history")))
        .reliability(static_cast<ReliabilityPolicy>(number("reliability")))
        .durability(static_cast<DurabilityPolicy>(number("durability")))
        .liveliness(static_cast<LivelinessPolicy>(number("liveliness")))
        .deadline(length("deadline"))
        .lifespan(length("lifespan"))
        .liveliness_lease_duration(length("liveliness_lease_duration"));
    found.push_back({each.items[0].string, each.items[1].string, each.items[2].string,
        static_cast<EndpointType>(each.items[3].whole), qos});
  }
  return found;
}
}  // namespace

std::vector<std::string> Node::get_node_names() const
{
  rosspin::look();
  return texts(field(base_->ask("node_names", {}, "failed to get node names"), "names"));
}

std::map<std::string, std::vector<std::string>> Node::get_topic_names_and_types() const
{
  rosspin::look();
  return types(base_->ask("topics", {}, "failed to get topic names and types"));
}

std::map<std::string, std::vector<std::string>> Node::get_service_names_and_types() const
{
  rosspin::look();
  return types(base_->ask("services", {}, "failed to get service names and types"));
}

std::map<std::string, std::vector<std::string>> Node::get_service_names_and_types_by_node(
    const std::string& name, const std::string& ns) const
{
  rosspin::look();
  return types(base_->ask("services_of", {name, ns}, "failed to get service names and types by node"));
}

bool Event::check()
{
  if (graph_)
  {
    rosspin::Value before = std::exchange(seen_, graph_());
    state_ = state_ || !(before == seen_);
  }
  return state_;
}

// A node's first event tells of what was before it, too: the guard condition was triggered then (source: graph_listener.cpp).
Event::SharedPtr Node::get_graph_event()
{
  auto graph = [base = base_] { return base->ask("graph", {}, "could not get the graph"); };
  auto event = std::make_shared<Event>(graph, graph_events_.empty() ? rosspin::Value() : graph());
  graph_events_.push_back(event);
  return event;
}

// It looks every 10 ms.
void Node::wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout)
{
  if (!event)
    throw exceptions::InvalidEventError();
  if (std::none_of(graph_events_.begin(), graph_events_.end(), [&](const auto& each) { return each.lock() == event; }))
    throw exceptions::EventNotRegisteredError();
  std::int64_t end = later(rosspin::now(), timeout.count());
  while (rosspin::now() < end && base_->get_context()->is_valid() && !event->check())
    rosspin::wait(std::min(end, rosspin::now() + 10'000'000));
}

#define ROSSPIN_COUNT(what)                                                                                            \
  std::size_t Node::count_##what(const std::string& name) const                                                        \
  {                                                                                                                    \
    rosspin::look();                                                                                                   \
    return field(base_->ask("count", {#what, name}, "could not count " #what), "count").whole;                         \
  }
ROSSPIN_COUNT(publishers)
ROSSPIN_COUNT(subscribers)
ROSSPIN_COUNT(clients)
ROSSPIN_COUNT(services)
#undef ROSSPIN_COUNT

std::vector<TopicEndpointInfo> Node::get_publishers_info_by_topic(const std::string& topic, bool no_mangle) const
{
  rosspin::look();
  return infos(base_->ask("infos", {"publishers", topic, no_mangle}, "could not get publishers info by topic"));
}

std::vector<TopicEndpointInfo> Node::get_subscriptions_info_by_topic(const std::string& topic, bool no_mangle) const
{
  rosspin::look();
  return infos(base_->ask("infos", {"subscriptions", topic, no_mangle}, "could not get subscriptions info by topic"));
}

// --- parameters (sources: node_parameters.cpp, parameter.cpp, parameter_value.cpp) ---

std::string to_string(ParameterType type)
{
  static const char* const names[] = {"not set", "bool", "integer", "double", "string", "byte_array", "bool_array",
      "integer_array", "double_array", "string_array"};
  return type <= PARAMETER_STRING_ARRAY ? names[type] : "unknown type";
}

std::ostream& operator<<(std::ostream& stream, ParameterType type) { return stream << to_string(type); }

ParameterValue::ParameterValue(const rcl_interfaces::msg::ParameterValue& value) : value_(value)
{
  if (value.type > PARAMETER_STRING_ARRAY)
    throw exceptions::UnknownTypeError(std::to_string(value.type));
}

namespace
{
template<class Shown, class T>
std::string listed(const std::vector<T>& items, std::ios::fmtflags flags = std::ios::dec)
{
  std::stringstream text;
  text.setf(flags, std::ios::basefield | std::ios::boolalpha);
  text << std::showbase << "[";
  for (std::size_t each = 0; each < items.size(); each++)
    text << (each ? ", " : "") << static_cast<Shown>(items[each]);
  text << "]";
  return text.str();
}
}  // namespace

std::string to_string(const ParameterValue& value)
{
  rcl_interfaces::msg::ParameterValue found = value.to_value_msg();
  switch (value.get_type())
  {
  case PARAMETER_BOOL:
    return found.bool_value ? "true" : "false";
  case PARAMETER_INTEGER:
    return std::to_string(found.integer_value);
  case PARAMETER_DOUBLE:
    return std::to_string(found.double_value);
  case PARAMETER_STRING:
    return found.string_value;
  case PARAMETER_BYTE_ARRAY:
    return listed<int>(found.byte_array_value, std::ios::hex);
  case PARAMETER_BOOL_ARRAY:
    return listed<bool>(found.bool_array_value, std::ios::boolalpha);
  case PARAMETER_INTEGER_ARRAY:
    return listed<std::int64_t>(found.integer_array_value);
  case PARAMETER_DOUBLE_ARRAY:
    return listed<double>(found.double_array_value);
  case PARAMETER_STRING_ARRAY:
    return listed<std::string>(found.string_array_value);
  default:
    return to_string(value.get_type());
  }
}

std::string _to_json_dict_entry(const Parameter& parameter)
{
  return "\"" + parameter.get_name() + "\": {\"type\": \"" + parameter.get_type_name() + "\", \"value\": \"" +
         parameter.value_to_string() + "\"}";
}

std::ostream& operator<<(std::ostream& stream, const Parameter& parameter)
{
  return stream << std::to_string(parameter);
}

std::ostream& operator<<(std::ostream& stream, const std::vector<Parameter>& parameters)
{
  return stream << std::to_string(parameters);
}

namespace node_interfaces
{
namespace
{
ParameterValue value_of(const rosspin::Value& value)
{
  using rosspin::Value;
  switch (value.kind)
  {
  case Value::boolean:
    return ParameterValue(value.flag);
  case Value::integer:
    return ParameterValue(value.whole);
  case Value::real:
    return ParameterValue(value.number);
  case Value::text:
    return ParameterValue(value.string);
  case Value::list:
  {
    auto gathered = [&](auto one, auto member)
    {
      std::vector<decltype(one)> items;
      for (const Value& item : value.items)
        items.push_back(item.*member);
      return ParameterValue(items);
    };
    switch (value.items.front().kind)
    {
    case Value::boolean:
      return gathered(bool(), &Value::flag);
    case Value::integer:
      return gathered(std::int64_t(), &Value::whole);
    case Value::real:
      return gathered(double(), &Value::number);
    default:
      return gathered(std::string(), &Value::string);
    }
  }
  default:
    return ParameterValue();
  }
}

bool equal(double one, double other)
{
  return std::abs(one - other) <= std::numeric_limits<double>::epsilon() * std::abs(one + other) * 100;
}

// Return why a value is out of the range that a descriptor allows; nothing if it is not.
std::string out_of_range(const rcl_interfaces::msg::ParameterDescriptor& descriptor, const ParameterValue& value)
{
  std::string reason = "Parameter {" + descriptor.name + "} doesn't comply with ";
  if (!descriptor.integer_range.empty() && value.get_type() == PARAMETER_INTEGER)
  {
    const auto& range = descriptor.integer_range[0];
    std::int64_t number = value.get<PARAMETER_INTEGER>();
    if (number == range.from_value || number == range.to_value)
      return "";
    bool outside = number < range.from_value || number > range.to_value;
    if (outside || (range.step && (number - range.from_value) % static_cast<std::int64_t>(range.step)))
      return reason + "integer range.";
  }
  if (!descriptor.floating_point_range.empty() && value.get_type() == PARAMETER_DOUBLE)
  {
    const auto& range = descriptor.floating_point_range[0];
    double number = value.get<PARAMETER_DOUBLE>();
    if (equal(number, range.from_value) || equal(number, range.to_value))
      return "";
    bool outside = number < range.from_value || number > range.to_value;
    if (outside ||
        (range.step != 0 &&
            !equal(number, range.from_value + std::round((number - range.from_value) / range.step) * range.step)))
      return reason + "floating point range.";
  }
  return "";
}

NodeParametersInterface::Result refused(const std::string& reason)
{
  NodeParametersInterface::Result result;
  result.successful = reason.empty();
  result.reason = reason;
  return result;
}

// Call those that live; the function returns whether to continue.
template<class Handle, class Function>
void call_each(std::list<std::weak_ptr<Handle>>& all, Function function)
{
  all.remove_if([](const auto& each) { return each.expired(); });
  for (const auto& each : std::list<std::weak_ptr<Handle>>(all))
    if (auto handle = each.lock(); handle && !function(*handle))
      return;
}
}  // namespace

// While parameters are changed, a callback may not change them.
struct NodeParametersInterface::Changing
{
  explicit Changing(bool& flag) : flag(flag)
  {
    if (flag)
      throw exceptions::ParameterModifiedInCallbackException(
          "cannot set or declare a parameter, or change the callback from within set callback");
    flag = true;
  }
  ~Changing() { flag = false; }
  bool& flag;
};

NodeParametersInterface::NodeParametersInterface(
    NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock, const NodeOptions& options)
  : node_(std::move(node)), clock_(std::move(clock)), allow_undeclared_(options.allow_undeclared_parameters()),
    tells_(options.start_parameter_event_publisher())
{
  if (options.start_parameter_services())
    offer_all();
  for (const auto& [name, value] : node_->overrides())
    overrides_[name] = value_of(value);
  for (const Parameter& parameter : options.parameter_overrides())
    overrides_[parameter.get_name()] = parameter.get_parameter_value();
  if (!options.automatically_declare_parameters_from_overrides())
    return;
  Descriptor descriptor;
  descriptor.dynamic_typing = true;
  for (const auto& [name, value] : overrides_)
    declare_parameter(name, value, descriptor, true);
}

template<class S, class Answer>
void NodeParametersInterface::offer(const char* name, Answer answer)
{
  typedef std::shared_ptr<typename S::Request> Request;
  typedef std::shared_ptr<typename S::Response> Response;
  auto call = [answer](Request request, Response response)
  {
    try
    {
      answer(*request, *response);
    }
    catch (const exceptions::ParameterNotDeclaredException&)
    {
    }
  };
  services_.push_back(
      std::make_shared<Service<S>>(node_, std::string(node_->get_name()) + "/" + name, call, ParametersQoS()));
  node_->get_default_callback_group()->add(services_.back());
  rosspin::await_spin(-1);  // no node waits for these
}

// Source: parameter_service.cpp.
void NodeParametersInterface::offer_all()
{
  namespace srv = rcl_interfaces::srv;
  auto set = [this](const std::vector<rcl_interfaces::msg::Parameter>& given, const std::string& reason)
  {
    std::vector<Parameter> parameters;
    for (const auto& each : given)
      parameters.push_back(Parameter::from_parameter_msg(each));
    try
    {
      return set_parameters_atomically(parameters);
    }
    catch (const exceptions::ParameterNotDeclaredException& error)
    {
      return refused(reason.empty() ? error.what() : reason);
    }
  };
  offer<srv::GetParameters>("get_parameters",
      [this](const auto& request, auto& response)
      {
        try
        {
          for (const Parameter& each : get_parameters(request.names))
            response.values.push_back(each.get_value_message());
        }
        catch (const exceptions::ParameterUninitializedException&)
        {
        }
      });
  offer<srv::GetParameterTypes>("get_parameter_types",
      [this](const auto& request, auto& response) { response.types = get_parameter_types(request.names); });
  offer<srv::SetParameters>("set_parameters",
      [set](const auto& request, auto& response)
      {
        for (const auto& each : request.parameters)
          response.results.push_back(set({each}, ""));
      });
  offer<srv::SetParametersAtomically>("set_parameters_atomically",
      [set](const auto& request, auto& response)
      { response.result = set(request.parameters, "One or more parameters were not declared before setting"); });
  offer<srv::DescribeParameters>("describe_parameters",
      [this](const auto& request, auto& response) { response.descriptors = describe_parameters(request.names); });
  offer<srv::ListParameters>("list_parameters",
      [this](const auto& request, auto& response)
      { response.result = list_parameters(request.prefixes, request.depth); });
}

// The host has the publisher, if someone listens.
void NodeParametersInterface::publish(rcl_interfaces::msg::ParameterEvent event) const
{
  if (!tells_)
    return;
  event.node = node_->get_fully_qualified_name();
  event.stamp = clock_->now();
  rosspin::tell("parameter_event", {node_->id(), bytes_of(detail::serialized(event))});
}

const ParameterValue& NodeParametersInterface::declare_parameter(
    const std::string& name, const ParameterValue& default_value, const Descriptor& descriptor, bool ignore_override)
{
  return declare(name, PARAMETER_NOT_SET, default_value, descriptor, ignore_override);
}

const ParameterValue& NodeParametersInterface::declare_parameter(
    const std::string& name, ParameterType type, const Descriptor& descriptor, bool ignore_override)
{
  if (type == PARAMETER_NOT_SET)
    throw std::invalid_argument(
        "declare_parameter(): the provided parameter type cannot be rclcpp::PARAMETER_NOT_SET");
  if (descriptor.dynamic_typing)
    throw std::invalid_argument("declare_parameter(): cannot declare parameter of specific type and pass descriptor"
                                "with `dynamic_typing=true`");
  return declare(name, type, ParameterValue(), descriptor, ignore_override);
}

const ParameterValue& NodeParametersInterface::declare(const std::string& name, ParameterType type,
    const ParameterValue& default_value, Descriptor descriptor, bool ignore_override)
{
  Changing changing(changing_);
  if (name.empty())
    throw exceptions::InvalidParametersException("parameter name must not be empty");
  if (all_.count(name))
    throw exceptions::ParameterAlreadyDeclaredException("parameter '" + name + "' has already been declared");
  if (!descriptor.dynamic_typing)
  {
    if (type == PARAMETER_NOT_SET)
      type = default_value.get_type();
    if (type == PARAMETER_NOT_SET)
      throw exceptions::InvalidParameterTypeException(
          name, "cannot declare a statically typed parameter with an uninitialized value");
    descriptor.type = type;
  }
  Result result = start(name, default_value, descriptor, all_, true, ignore_override);
  if (!result.successful)
  {
    if (result.reason.rfind("Wrong parameter type", 0) == 0)
      throw exceptions::InvalidParameterTypeException(name, result.reason);
    throw exceptions::InvalidParameterValueException("parameter '" + name + "' could not be set: " + result.reason);
  }
  rcl_interfaces::msg::ParameterEvent event;
  if (const ParameterValue& value = all_.at(name).value; value.get_type() != PARAMETER_NOT_SET)
    event.new_parameters.push_back(Parameter(name, value).to_parameter_msg());
  publish(event);
  return all_.at(name).value;
}

NodeParametersInterface::Result NodeParametersInterface::start(const std::string& name,
    const ParameterValue& default_value, const Descriptor& descriptor, Infos& into, bool with_callbacks,
    bool ignore_override)
{
  auto found = overrides_.find(name);
  const ParameterValue& value = ignore_override || found == overrides_.end() ? default_value : found->second;
  Infos infos{{name, {ParameterValue(), descriptor}}};
  Result result = refused("");
  if (value.get_type() == PARAMETER_NOT_SET)
  {
    infos[name].descriptor.name = name;
    infos[name].descriptor.type = descriptor.dynamic_typing ? PARAMETER_NOT_SET : descriptor.type;
  }
  else
  {
    result = set({Parameter(name, value)}, infos, with_callbacks, false);
  }
  if (result.successful)
    into[name] = infos[name];
  return result;
}

NodeParametersInterface::Result NodeParametersInterface::set(
    const std::vector<Parameter>& parameters, Infos& infos, bool with_callbacks, bool allow_undeclared)
{
  for (const Parameter& parameter : parameters)
  {
    const std::string& name = parameter.get_name();
    Descriptor descriptor;
    if (auto found = infos.find(name); found != infos.end())
      descriptor = found->second.descriptor;
    else
      descriptor.dynamic_typing = allow_undeclared;
    descriptor.name = name;
    if (!descriptor.dynamic_typing && descriptor.type != parameter.get_type())
      return refused("Wrong parameter type, parameter {" + name + "} is of type {" +
                     to_string(static_cast<ParameterType>(descriptor.type)) + "}, setting it to {" +
                     to_string(parameter.get_type()) + "} is not allowed.");
    if (std::string reason = out_of_range(descriptor, parameter.get_parameter_value()); !reason.empty())
      return refused(reason);
  }
  Result result = refused("");
  if (with_callbacks)
    call_each(on,
        [&](OnSetParametersCallbackHandle& handle)
        {
          result = handle.callback(parameters);
          return result.successful;
        });
  if (!result.successful)
    return result;
  for (const Parameter& parameter : parameters)
  {
    Info& info = infos[parameter.get_name()];
    info.descriptor.name = parameter.get_name();
    info.descriptor.type = parameter.get_type();
    info.value = parameter.get_parameter_value();
  }
  if (with_callbacks)
    call_each(after, [&](PostSetParametersCallbackHandle& handle) { return handle.callback(parameters), true; });
  return result;
}

void NodeParametersInterface::undeclare_parameter(const std::string& name)
{
  Changing changing(changing_);
  auto found = all_.find(name);
  if (found == all_.end())
    throw exceptions::ParameterNotDeclaredException(
        "cannot undeclare parameter '" + name + "' which has not yet been declared");
  if (found->second.descriptor.read_only)
    throw exceptions::ParameterImmutableException("cannot undeclare parameter '" + name + "' because it is read-only");
  if (!found->second.descriptor.dynamic_typing)
    throw exceptions::InvalidParameterTypeException(name, "cannot undeclare a statically typed parameter");
  all_.erase(found);
}

std::vector<NodeParametersInterface::Result> NodeParametersInterface::set_parameters(
    const std::vector<Parameter>& parameters)
{
  std::vector<Result> results;
  for (const Parameter& parameter : parameters)
    results.push_back(set_parameters_atomically({parameter}));
  return results;
}

NodeParametersInterface::Result NodeParametersInterface::set_parameters_atomically(
    const std::vector<Parameter>& given)
{
  Changing changing(changing_);
  std::vector<Parameter> parameters = given;
  call_each(before, [&](PreSetParametersCallbackHandle& handle) { return handle.callback(parameters), true; });
  if (parameters.empty())
    return refused("parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the "
                   "original parameters list.");
  Infos started;
  for (const Parameter& parameter : parameters)
  {
    const std::string& name = parameter.get_name();
    if (name.empty())
      throw exceptions::InvalidParametersException("parameter name must not be empty");
    auto found = all_.find(name);
    if (found == all_.end() && !allow_undeclared_)
      throw exceptions::ParameterNotDeclaredException(
          "parameter '" + name + "' cannot be set because it was not declared");
    if (found != all_.end() && found->second.descriptor.read_only)
      return refused("parameter '" + name + "' cannot be set because it is read-only");
    if (found == all_.end())
    {
      Descriptor descriptor;
      descriptor.dynamic_typing = true;
      if (Result result = start(name, parameter.get_parameter_value(), descriptor, started, false, true);
          !result.successful)
        return result;
    }
    else if (parameter.get_type() == PARAMETER_NOT_SET && found->second.value.get_type() != PARAMETER_NOT_SET &&
             !found->second.descriptor.dynamic_typing)
    {
      return refused("cannot undeclare a statically typed parameter");
    }
  }
  std::set<std::string> to_go;
  for (const Parameter& parameter : parameters)
    if (parameter.get_type() == PARAMETER_NOT_SET && all_.count(parameter.get_name()) &&
        all_[parameter.get_name()].value.get_type() != PARAMETER_NOT_SET)
      to_go.insert(parameter.get_name());
  Result result = set(parameters, all_, true, allow_undeclared_);
  if (!result.successful)
    return result;
  rcl_interfaces::msg::ParameterEvent event;
  for (const auto& [name, info] : started)
  {
    all_[name] = info;
    if (info.value.get_type() != PARAMETER_NOT_SET)
      event.new_parameters.push_back(Parameter(name, info.value).to_parameter_msg());
  }
  for (const std::string& name : to_go)
  {
    event.deleted_parameters.push_back(Parameter(name, all_[name].value).to_parameter_msg());
    all_.erase(name);
  }
  for (const Parameter& parameter : parameters)
    if (!started.count(parameter.get_name()) && !to_go.count(parameter.get_name()))
      event.changed_parameters.push_back(parameter.to_parameter_msg());
  publish(event);
  for (const Parameter& parameter : parameters)
    if (parameter.get_name() == "use_sim_time" && parameter.get_type() == PARAMETER_BOOL && on_use_sim_time)
      on_use_sim_time(parameter.as_bool());
  return result;
}

std::vector<Parameter> NodeParametersInterface::get_parameters(const std::vector<std::string>& names) const
{
  std::vector<Parameter> found;
  for (const std::string& name : names)
    found.push_back(get_parameter(name));
  return found;
}

Parameter NodeParametersInterface::get_parameter(const std::string& name) const
{
  auto found = all_.find(name);
  if (found == all_.end())
  {
    if (allow_undeclared_)
      return Parameter(name);
    throw exceptions::ParameterNotDeclaredException(name);
  }
  if (found->second.value.get_type() == PARAMETER_NOT_SET && !found->second.descriptor.dynamic_typing)
    throw exceptions::ParameterUninitializedException(name);
  return Parameter(name, found->second.value);
}

bool NodeParametersInterface::get_parameter(const std::string& name, Parameter& parameter) const
{
  auto found = all_.find(name);
  if (found == all_.end() || found->second.value.get_type() == PARAMETER_NOT_SET)
    return false;
  parameter = Parameter(name, found->second.value);
  return true;
}

bool NodeParametersInterface::get_parameters_by_prefix(
    const std::string& prefix, std::map<std::string, Parameter>& parameters) const
{
  std::string start = prefix.empty() ? prefix : prefix + ".";
  bool any = false;
  for (const auto& [name, info] : all_)
    if (name.rfind(start, 0) == 0 && name.size() > start.size())
    {
      parameters[name.substr(start.size())] = Parameter(name, info.value);
      any = true;
    }
  return any;
}

std::vector<NodeParametersInterface::Descriptor> NodeParametersInterface::describe_parameters(
    const std::vector<std::string>& names) const
{
  std::vector<Descriptor> descriptors;
  for (const std::string& name : names)
  {
    auto found = all_.find(name);
    if (found == all_.end() && !allow_undeclared_)
      throw exceptions::ParameterNotDeclaredException(name);
    descriptors.push_back(found == all_.end() ? Descriptor() : found->second.descriptor);
    descriptors.back().name = name;
  }
  return descriptors;
}

std::vector<std::uint8_t> NodeParametersInterface::get_parameter_types(const std::vector<std::string>& names) const
{
  std::vector<std::uint8_t> types;
  for (const std::string& name : names)
  {
    auto found = all_.find(name);
    if (found == all_.end() && !allow_undeclared_)
      throw exceptions::ParameterNotDeclaredException(name);
    types.push_back(found == all_.end() ? PARAMETER_NOT_SET : found->second.value.get_type());
  }
  return types;
}

rcl_interfaces::msg::ListParametersResult NodeParametersInterface::list_parameters(
    const std::vector<std::string>& prefixes, std::uint64_t depth) const
{
  rcl_interfaces::msg::ListParametersResult result;
  auto shallow = [&](const std::string& name)
  { return depth == 0 || static_cast<std::uint64_t>(std::count(name.begin(), name.end(), '.')) < depth; };
  for (const auto& [name, info] : all_)
  {
    bool wanted = prefixes.empty() && shallow(name);
    for (const std::string& prefix : prefixes)
      wanted = wanted || name == prefix ||
               (name.rfind(prefix + ".", 0) == 0 && shallow(name.substr(prefix.size() + 1)));
    if (!wanted)
      continue;
    result.names.push_back(name);
    if (std::size_t at = name.rfind('.'); at != std::string::npos)
      if (std::string prefix = name.substr(0, at);
          std::find(result.prefixes.begin(), result.prefixes.end(), prefix) == result.prefixes.end())
        result.prefixes.push_back(prefix);
  }
  return result;
}
}  // namespace node_interfaces

// --- executors (sources: executor.cpp, executors/*.cpp) ---

std::ostream& operator<<(std::ostream& stream, const FutureReturnCode& code) { return stream << to_string(code); }

std::string to_string(const FutureReturnCode& code)
{
  static const char* const names[] = {"SUCCESS", "INTERRUPTED", "TIMEOUT"};
  return std::string(names[static_cast<int>(code)]) + " (" + std::to_string(static_cast<int>(code)) + ")";
}

struct Executor::Spinning
{
  Spinning(Executor& executor, const char* what) : executor(executor)
  {
    if (executor.spinning_)
      throw std::runtime_error(std::string(what) + "() called while already spinning");
    executor.spinning_ = true;
    rosspin::spins();
  }
  ~Spinning()
  {
    executor.taken_.clear();
    executor.spinning_ = false;
  }
  Executor& executor;
};

Executor::Executor(const ExecutorOptions& options) : context_(options.context)
{
  context_->check("failed to create guard condition");
}

Executor::~Executor()
{
  for (const auto& each : nodes_)
    if (auto node = each.lock())
      node->get_associated_with_executor_atomic() = false;
  for (const auto& each : groups_)
    if (auto group = each.lock())
      group->get_associated_with_executor_atomic() = false;
}

void Executor::add_node(Base node, bool)
{
  if (node->get_associated_with_executor_atomic().exchange(true))
    throw std::runtime_error("Node '" + std::string(node->get_fully_qualified_name()) +
                             "' has already been added to an executor.");
  nodes_.push_back(node);
  detail::changed();
  if (!spinning_)
    collect();
}

void Executor::remove_node(Base node, bool)
{
  auto is_it = [&](const auto& each) { return each.lock() == node; };
  auto found = std::find_if(nodes_.begin(), nodes_.end(), is_it);
  if (found == nodes_.end())
    throw std::runtime_error("Node '" + std::string(node->get_fully_qualified_name()) + "' needs to be associated with " +
                             (node->get_associated_with_executor_atomic() ? "this executor." : "an executor."));
  nodes_.erase(found);
  node->get_associated_with_executor_atomic() = false;
  detail::changed();
  if (!spinning_)
    collect();
}

void Executor::add_callback_group(CallbackGroup::SharedPtr group, Base, bool)
{
  if (group->get_associated_with_executor_atomic().exchange(true))
    throw std::runtime_error("Callback group has already been added to an executor.");
  groups_.push_back(group);
  detail::changed();
  if (!spinning_)
    collect();
}

void Executor::remove_callback_group(CallbackGroup::SharedPtr group, bool)
{
  auto found = std::find_if(groups_.begin(), groups_.end(), [&](const auto& each) { return each.lock() == group; });
  if (found == groups_.end())
    throw std::runtime_error("Callback group needs to be associated with an executor.");
  groups_.erase(found);
  group->get_associated_with_executor_atomic() = false;
  detail::changed();
}

// Of what is new, the newest comes first, after all that was there: rclcpp puts it into a hash table, which happens to do
// that (source: executor_entities_collection.hpp; in all recordings).
void Executor::collect()
{
  seen_ = detail::changes;
  std::vector<std::shared_ptr<detail::Callable>> found;
  auto take = [&](const CallbackGroup::SharedPtr& group)
  {
    auto members = group->members();
    found.insert(found.end(), members.begin(), members.end());
  };
  for (const auto& each : nodes_)
    if (auto node = each.lock())
      node->for_each_callback_group(
          [&](const CallbackGroup::SharedPtr& group)
          {
            if (group->automatically_add_to_executor_with_node() && !group->get_associated_with_executor_atomic())
              take(group);
          });
  for (const auto& each : groups_)
    if (auto group = each.lock())
      take(group);
  auto is_in = [](const auto& all, const auto& one) { return std::find(all.begin(), all.end(), one) != all.end(); };
  std::vector<std::shared_ptr<detail::Callable>> kept;
  for (const auto& each : known_)
    if (auto callable = each.lock(); callable && is_in(found, callable))
      kept.push_back(callable);
  std::size_t old = kept.size();
  for (auto each = found.rbegin(); each != found.rend(); each++)
    if (std::find(kept.begin(), kept.begin() + old, *each) == kept.begin() + old)
      kept.push_back(*each);
  known_.assign(kept.begin(), kept.end());
  found_.clear();
  for (const auto& each : kept)
    found_.push_back(each.get());
}

bool Executor::goes_on() const { return spinning_ && context_->is_valid(); }

// Take what is due, and return when the first of the others is.
std::int64_t Executor::take_due()
{
  using detail::Callable;
  static const Callable::Kind usual[] = {
      Callable::timer, Callable::subscription, Callable::service, Callable::client, Callable::event};
  static const Callable::Kind statically[] = {
      Callable::subscription, Callable::timer, Callable::client, Callable::service, Callable::event};
  std::int64_t now = rosspin::detail::time(), next = rosspin::never;
  for (std::size_t each = 0; each < found_.size(); each++)
    if (found_[each]->is_free())
    {
      std::int64_t due = found_[each]->due();
      if (due > now)
        next = std::min(next, due);
      else if (auto callable = known_[each].lock())
        taken_.push_back(std::move(callable));
    }
  if (taken_.size() > 1)
  {
    std::deque<std::shared_ptr<Callable>> sorted;
    for (Callable::Kind kind : statically_ ? statically : usual)
      for (const auto& callable : taken_)
        if (callable->kind == kind)
          sorted.push_back(callable);
    taken_.swap(sorted);
  }
  return next;
}

void Executor::wait_for_work(std::int64_t timeout)
{
  taken_.clear();
  std::int64_t end = timeout < 0 ? rosspin::never : later(rosspin::now(), timeout);
  rosspin::wait(rosspin::now());  // what has come is seen
  for (;;)
  {
    rosspin::look();
    if (needs_collecting())
      collect();
    std::int64_t next = take_due();
    if (!taken_.empty() || rosspin::detail::time() >= end || !goes_on())
      return;
    rosspin::wait(std::min(end, next));
  }
}

bool Executor::call_next()
{
  if (taken_.empty())
    return false;
  auto callable = taken_.front();
  taken_.pop_front();
  callable->call_back();
  return true;
}

void Executor::spin_once(std::chrono::nanoseconds timeout)
{
  Spinning spinning(*this, "spin_once");
  wait_for_work(timeout.count());
  if (spinning_)
    call_next();
}

void Executor::spin_some(std::chrono::nanoseconds max_duration, bool exhaustive)
{
  Spinning spinning(*this, "spin_some");
  std::int64_t begun = rosspin::now();
  wait_for_work(0);
  bool just_waited = true;
  while (goes_on() && (max_duration.count() == 0 || rosspin::now() - begun < max_duration.count()))
  {
    if (call_next())
    {
      just_waited = false;
      continue;
    }
    if (just_waited || !exhaustive)
      return;
    wait_for_work(0);
    just_waited = true;
  }
}

void Executor::spin_all(std::chrono::nanoseconds max_duration)
{
  if (max_duration.count() < 0)
    throw std::invalid_argument("max_duration must be greater than or equal to 0");
  spin_some(max_duration, true);
}

void Executor::spin_node_some(Base node)
{
  add_node(node, false);
  spin_some();
  remove_node(node, false);
}

void Executor::spin_node_all(Base node, std::chrono::nanoseconds max_duration)
{
  add_node(node, false);
  spin_all(max_duration);
  remove_node(node, false);
}

FutureReturnCode Executor::spin_until(const std::function<bool()>& is_ready, std::chrono::nanoseconds timeout)
{
  if (is_ready())
    return FutureReturnCode::SUCCESS;
  std::int64_t end = timeout.count() > 0 ? later(rosspin::now(), timeout.count()) : rosspin::now(), left = timeout.count();
  Spinning spinning(*this, "spin_until_future_complete");
  while (goes_on())
  {
    if (taken_.empty())
      wait_for_work(left);
    if (spinning_)
      call_next();
    if (is_ready())
      return FutureReturnCode::SUCCESS;
    if (timeout.count() < 0)
      continue;
    if (rosspin::now() >= end)
      return FutureReturnCode::TIMEOUT;
    left = end - rosspin::now();
  }
  return FutureReturnCode::INTERRUPTED;
}

namespace executors
{
void SingleThreadedExecutor::spin()
{
  Spinning spinning(*this, "spin");
  rosspin::Ticking::leave_loops();
  while (goes_on())
    if (!call_next())
      wait_for_work(-1);
}

void MultiThreadedExecutor::spin()
{
  Spinning spinning(*this, "spin");
  rosspin::Ticking::leave_loops();
  std::vector<std::thread> threads;
  while (threads.size() + 1 < threads_)
    threads.emplace_back([this] { run(); });
  run();
  for (std::thread& each : threads)
    each.join();
}

void MultiThreadedExecutor::run()
{
  while (goes_on())
  {
    auto callable = take();
    if (!callable)
      continue;
    auto group = callable->group.lock();
    callable->call_back();
    if (group)
      group->can_be_taken_from() = true;
    rosspin::stir();
  }
}

// One thread at a time waits for calls; calls of a group in which one is made already come later.
std::shared_ptr<detail::Callable> MultiThreadedExecutor::take()
{
  std::lock_guard<std::mutex> lock(mutex_);
  auto is_free = [](const auto& callable) { return callable->is_free(); };
  auto found = std::find_if(taken_.begin(), taken_.end(), is_free);
  if (found == taken_.end())
  {
    wait_for_work(-1);
    found = taken_.begin();
  }
  if (found == taken_.end() || !goes_on())
    return nullptr;
  auto callable = *found;
  taken_.erase(found);
  if (auto group = callable->group.lock(); group && group->type() == CallbackGroupType::MutuallyExclusive)
    group->can_be_taken_from() = false;
  return callable;
}
}  // namespace executors

namespace experimental
{
namespace executors
{
// A thread of rclcpp's notes each timer when it is due, as its call; the calls are made one after the other (source:
// timers_manager.cpp, execute_ready_timers_unsafe).
void EventsExecutor::spin()
{
  Spinning spinning(*this, "spin");
  rosspin::Ticking::leave_loops();
  while (goes_on())
  {
    rosspin::wait(rosspin::now());  // what has come is seen
    if (needs_collecting())
      collect();
    std::shared_ptr<detail::Callable> first;
    for (const auto& each : known_)
      if (auto callable = each.lock(); callable && (!first || callable->due() < first->due()))
        first = callable;
    std::int64_t due = first ? first->due() : rosspin::never;
    if (due > rosspin::now())
      rosspin::wait(due);
    else if (first->kind == detail::Callable::timer)
      static_cast<TimerBase&>(*first).call_back(
          static_cast<TimerBase&>(*first).clock().ns() - (rosspin::now() - due));
    else
      first->call_back();
  }
}
}  // namespace executors
}  // namespace experimental

// --- the parameters of another node (sources: parameter_client.cpp, parameter_event_handler.cpp) ---

AsyncParametersClient::AsyncParametersClient(node_interfaces::NodeBaseInterface::SharedPtr node,
    const std::string& remote_node_name, const QoS& qos, CallbackGroup::SharedPtr group)
  : node_(std::move(node))
{
  auto in = node_->group_for(group, "client");
  std::string remote = remote_node_name.empty() ? node_->get_fully_qualified_name() : remote_node_name;
  auto make = [&](auto& client, const char* name)
  {
    typedef typename std::decay_t<decltype(client)>::element_type Made;
    client = std::make_shared<Made>(node_, remote + "/" + name, qos);
    in->add(client);
  };
  make(get_, "get_parameters");
  make(get_types_, "get_parameter_types");
  make(set_, "set_parameters");
  make(set_atomically_, "set_parameters_atomically");
  make(list_, "list_parameters");
  make(describe_, "describe_parameters");
}

namespace
{
// Ask, and settle the future with what `read` makes of the response.
template<class T, class S, class Fill, class Read>
std::shared_future<T> asked(Client<S>& client, Fill fill, std::function<void(std::shared_future<T>)> call, Read read)
{
  auto request = std::make_shared<typename S::Request>();
  fill(*request);
  auto promise = std::make_shared<std::promise<T>>();
  std::shared_future<T> future = promise->get_future().share();
  client.async_send_request(request,
      [promise, future, call = std::move(call), read](typename Client<S>::SharedFuture response)
      {
        promise->set_value(read(*response.get()));
        if (call)
          call(future);
      });
  return future;
}

std::vector<rcl_interfaces::msg::Parameter> messages(const std::vector<Parameter>& parameters)
{
  std::vector<rcl_interfaces::msg::Parameter> made;
  for (const Parameter& each : parameters)
    made.push_back(each.to_parameter_msg());
  return made;
}
}  // namespace

std::shared_future<std::vector<Parameter>> AsyncParametersClient::get_parameters(
    const std::vector<std::string>& names, Call<std::vector<Parameter>> call)
{
  auto read = [names](const auto& response)
  {
    std::vector<Parameter> parameters;
    for (const auto& value : response.values)
      parameters.emplace_back(names[parameters.size()], ParameterValue(value));
    return parameters;
  };
  return asked(*get_, [&](auto& request) { request.names = names; }, std::move(call), read);
}

std::shared_future<std::vector<AsyncParametersClient::Descriptor>> AsyncParametersClient::describe_parameters(
    const std::vector<std::string>& names, Call<std::vector<Descriptor>> call)
{
  return asked(*describe_, [&](auto& request) { request.names = names; }, std::move(call),
      [](const auto& response) { return response.descriptors; });
}

std::shared_future<std::vector<ParameterType>> AsyncParametersClient::get_parameter_types(
    const std::vector<std::string>& names, Call<std::vector<ParameterType>> call)
{
  auto read = [](const auto& response)
  {
    std::vector<ParameterType> types;
    for (std::uint8_t type : response.types)
      types.push_back(static_cast<ParameterType>(type));
    return types;
  };
  return asked(*get_types_, [&](auto& request) { request.names = names; }, std::move(call), read);
}

std::shared_future<std::vector<AsyncParametersClient::Set>> AsyncParametersClient::set_parameters(
    const std::vector<Parameter>& parameters, Call<std::vector<Set>> call)
{
  return asked(*set_, [&](auto& request) { request.parameters = messages(parameters); }, std::move(call),
      [](const auto& response) { return response.results; });
}

std::shared_future<AsyncParametersClient::Set> AsyncParametersClient::set_parameters_atomically(
    const std::vector<Parameter>& parameters, Call<Set> call)
{
  return asked(*set_atomically_, [&](auto& request) { request.parameters = messages(parameters); }, std::move(call),
      [](const auto& response) { return response.result; });
}

std::shared_future<AsyncParametersClient::Listed> AsyncParametersClient::list_parameters(
    const std::vector<std::string>& prefixes, std::uint64_t depth, Call<Listed> call)
{
  auto fill = [&](auto& request)
  {
    request.prefixes = prefixes;
    request.depth = depth;
  };
  return asked(*list_, fill, std::move(call), [](const auto& response) { return response.result; });
}

bool AsyncParametersClient::service_is_ready() const
{
  const ClientBase* all[] = {get_.get(), get_types_.get(), set_.get(), list_.get(), describe_.get()};
  return std::all_of(std::begin(all), std::end(all), [](const ClientBase* each) { return each->service_is_ready(); });
}

bool AsyncParametersClient::wait_for_service_nanoseconds(std::chrono::nanoseconds timeout)
{
  ClientBase* all[] = {get_.get(), get_types_.get(), set_.get(), list_.get(), describe_.get()};
  std::int64_t end = later(rosspin::now(), timeout.count());
  for (ClientBase* each : all)
  {
    std::int64_t left = timeout.count() < 0 ? timeout.count() : std::max<std::int64_t>(end - rosspin::now(), 0);
    if (!each->wait_for_service(std::chrono::nanoseconds(left)))
      return false;
  }
  return true;
}

namespace
{
template<class Handle>
void removed(std::list<std::weak_ptr<Handle>>& all, const std::shared_ptr<Handle>& handle)
{
  auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.lock() == handle; });
  if (found == all.end())
    throw std::runtime_error("Callback doesn't exist");
  all.erase(found);
}
}  // namespace

ParameterEventCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_event_callback(
    ParameterEventCallbackType callback)
{
  auto handle = std::make_shared<ParameterEventCallbackHandle>();
  handle->callback = std::move(callback);
  callbacks_->of_events.push_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_event_callback(ParameterEventCallbackHandle::SharedPtr handle)
{
  removed(callbacks_->of_events, handle);
}

ParameterCallbackHandle::SharedPtr ParameterEventHandler::add_parameter_callback(
    const std::string& parameter_name, ParameterCallbackType callback, const std::string& node_name)
{
  std::string around = node_->get_namespace();
  auto handle = std::make_shared<ParameterCallbackHandle>();
  handle->parameter_name = parameter_name;
  handle->node_name = node_name;
  if (node_name.empty())
    handle->node_name = node_->get_fully_qualified_name();
  else if (node_name.front() != '/')
    handle->node_name = (around == "/" ? around : around + "/") + node_name;
  handle->callback = std::move(callback);
  callbacks_->of_parameters.push_front(handle);
  return handle;
}

void ParameterEventHandler::remove_parameter_callback(ParameterCallbackHandle::SharedPtr handle)
{
  removed(callbacks_->of_parameters, handle);
}

bool ParameterEventHandler::get_parameter_from_event(
    const Event& event, Parameter& parameter, const std::string& parameter_name, const std::string& node_name)
{
  if (event.node != node_name)
    return false;
  for (const Parameter& each : get_parameters_from_event(event))
    if (each.get_name() == parameter_name)
    {
      parameter = each;
      return true;
    }
  return false;
}

Parameter ParameterEventHandler::get_parameter_from_event(
    const Event& event, const std::string& parameter_name, const std::string& node_name)
{
  Parameter parameter(parameter_name);
  if (!get_parameter_from_event(event, parameter, parameter_name, node_name) && event.node != node_name)
    throw std::runtime_error("The node name '" + node_name + "' of parameter '" + parameter_name +
                             "' doesn't match the node name '" + event.node + "' in parameter event");
  return parameter;
}

std::vector<Parameter> ParameterEventHandler::get_parameters_from_event(const Event& event)
{
  std::vector<Parameter> found;
  for (const auto* each : {&event.new_parameters, &event.changed_parameters})
    for (const auto& message : *each)
      found.push_back(Parameter::from_parameter_msg(message));
  return found;
}

void ParameterEventHandler::Callbacks::call(const Event& event)
{
  Parameter parameter;
  for (const auto& each : std::list<ParameterCallbackHandle::WeakPtr>(of_parameters))
    if (auto handle = each.lock();
        handle && get_parameter_from_event(event, parameter, handle->parameter_name, handle->node_name))
      handle->callback(parameter);
  for (const auto& each : std::list<ParameterEventCallbackHandle::WeakPtr>(of_events))
    if (auto handle = each.lock())
      handle->callback(event);
}

// --- wait sets (source: wait_set_template.hpp, sequential_synchronization.hpp) ---

GuardCondition::GuardCondition(Context::SharedPtr context) : context_(std::move(context))
{
  if (!context_)
    throw std::invalid_argument("context argument unexpectedly nullptr");
  context_->check("failed to create guard condition");
}

std::int64_t WaitSet::look()
{
  std::int64_t next = rosspin::never;
  auto callables = [&](const auto& all, std::vector<const void*>& ready, std::size_t& size)
  {
    ready.clear();
    for (const auto& each : all)
    {
      next = std::min(next, each->is_due() ? rosspin::now() : each->due());
      ready.push_back(each->is_due() ? each.get() : nullptr);
    }
    size = all.size();
  };
  callables(subscriptions_, ready_.subscriptions, ready_.size_of_subscriptions);
  callables(timers_, ready_.timers, ready_.size_of_timers);
  callables(clients_, ready_.clients, ready_.size_of_clients);
  callables(services_, ready_.services, ready_.size_of_services);
  ready_.guard_conditions.clear();
  for (const auto& each : guard_conditions_)
  {
    ready_.guard_conditions.push_back(each->take() ? each.get() : nullptr);
    if (ready_.guard_conditions.back())
      next = rosspin::now();
  }
  ready_.size_of_guard_conditions = guard_conditions_.size();
  return next;
}

// Ctrl-C does not end the wait.
WaitResultKind WaitSet::wait_nanoseconds(std::chrono::nanoseconds timeout)
{
  if (subscriptions_.empty() && guard_conditions_.empty() && timers_.empty() && clients_.empty() && services_.empty())
    return WaitResultKind::Empty;
  rosspin::spins();
  std::int64_t end = timeout.count() < 0 ? rosspin::never : later(rosspin::now(), timeout.count()), next;
  rosspin::wait(rosspin::now());  // what has come is seen
  while ((next = look()) > rosspin::now())
  {
    if (rosspin::now() >= end)
      return WaitResultKind::Timeout;
    rosspin::wait(std::min(end, next));
  }
  return WaitResultKind::Ready;
}

namespace detail
{
bool wait_for(const Callable& callable, const Context& context, std::int64_t timeout)
{
  std::int64_t end = timeout < 0 ? rosspin::never : later(rosspin::now(), timeout);
  rosspin::spins();
  rosspin::wait(rosspin::now());
  while (!callable.is_due() && context.is_valid() && rosspin::now() < end)
    rosspin::wait(end);
  return callable.is_due() && context.is_valid();
}
}  // namespace detail

void spin(Executor::Base node)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor executor(options);
  executor.add_node(node);
  executor.spin();
  executor.remove_node(node);
}

void spin(std::shared_ptr<Node> node) { spin(node->get_node_base_interface()); }

void spin_some(Executor::Base node)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor(options).spin_node_some(node);
}

void spin_some(std::shared_ptr<Node> node) { spin_some(node->get_node_base_interface()); }

void spin_all(Executor::Base node, std::chrono::nanoseconds max_duration)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor(options).spin_node_all(node, max_duration);
}

void spin_all(std::shared_ptr<Node> node, std::chrono::nanoseconds max_duration)
{
  spin_all(node->get_node_base_interface(), max_duration);
}
}  // namespace rclcpp

namespace std
{
string to_string(const rclcpp::Parameter& parameter)
{
  return "{\"name\": \"" + parameter.get_name() + "\", \"type\": \"" + parameter.get_type_name() +
         "\", \"value\": \"" + parameter.value_to_string() + "\"}";
}

string to_string(const vector<rclcpp::Parameter>& parameters)
{
  string all = "{";
  for (const auto& parameter : parameters)
    all += (all.size() > 1 ? ", " : "") + rclcpp::_to_json_dict_entry(parameter);
  return all + "}";
}
}  // namespace std

// --- rcutils ---

rcutils_ret_t rcutils_logging_set_logger_level(const char* name, int level)
{
  if (level % 10 || level < 0 || level > 50)
    return RCUTILS_RET_INVALID_ARGUMENT;
  if (*name)
    rclcpp::logs().levels[name] = level;
  else
    rclcpp::logs().level = level;
  return RCUTILS_RET_OK;
}

int rcutils_logging_get_logger_level(const char* name)
{
  auto found = rclcpp::logs().levels.find(name);
  return found == rclcpp::logs().levels.end() ? RCUTILS_LOG_SEVERITY_UNSET : found->second;
}

int rcutils_logging_get_logger_effective_level(const char* name)
{
  const auto& levels = rclcpp::logs().levels;
  if (!levels.empty())
    for (std::string at = name; !at.empty();)
    {
      if (auto found = levels.find(at); found != levels.end() && found->second)
        return found->second;
      std::size_t dot = at.rfind('.');
      at.resize(dot == std::string::npos ? 0 : dot);
    }
  return rclcpp::logs().level;
}

void rcutils_logging_set_default_logger_level(int level) { rclcpp::logs().level = level; }

// --- components (source: rclcpp_components/node_main.cpp.in) ---

namespace rclcpp_components
{
std::vector<Make>& components()
{
  static auto* all = new std::vector<Make>;
  return *all;
}
}  // namespace rclcpp_components

// The program of a file that has none of its own: it runs the components of that.
__attribute__((weak)) int main(int argc, char** argv)
{
  if (rclcpp_components::components().empty())
  {
    std::fputs("rosspin: this file has neither a main nor a component (RCLCPP_COMPONENTS_REGISTER_NODE)\n", stderr);
    return 1;
  }
  auto words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  {
    rclcpp::executors::SingleThreadedExecutor executor;
    rclcpp::NodeOptions options;
    options.arguments(words);
    std::vector<rclcpp_components::Component> made;
    for (const auto& make : rclcpp_components::components())
    {
      made.push_back(make(options));
      executor.add_node(made.back().base);
    }
    executor.spin();
    for (const auto& component : made)
      executor.remove_node(component.base);
  }
  rclcpp::shutdown();
  return 0;
}
