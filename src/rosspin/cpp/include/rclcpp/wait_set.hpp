// Wait sets of rclcpp: whoever has one waits without an executor.
#ifndef ROSSPIN_RCLCPP_WAIT_SET_HPP
#define ROSSPIN_RCLCPP_WAIT_SET_HPP

#include <array>

#include "rclcpp/node.hpp"

// What is ready of a set, each at its place: the others are null.
struct rcl_wait_set_t
{
  std::vector<const void*> subscriptions, guard_conditions, timers, clients, services, events;
  std::size_t size_of_subscriptions = 0, size_of_guard_conditions = 0, size_of_timers = 0, size_of_clients = 0,
              size_of_services = 0, size_of_events = 0;
};

namespace rclcpp
{
class GuardCondition
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition)
  explicit GuardCondition(Context::SharedPtr context = contexts::get_global_default_context());
  RCLCPP_DISABLE_COPY(GuardCondition)
  Context::SharedPtr get_context() const { return context_; }
  void trigger()
  {
    triggered_ = true;
    rosspin::stir();
  }

  // What follows is not rclcpp's.
  bool take() { return std::exchange(triggered_, false); }

private:
  Context::SharedPtr context_;
  bool triggered_ = false;
};

struct SubscriptionWaitSetMask
{
  bool include_subscription = true, include_events = true, include_intra_process_waitable = true;
};

enum class WaitResultKind
{
  Ready,
  Timeout,
  Empty,
  Invalid
};

template<class Set>
class WaitResult
{
public:
  WaitResult(WaitResultKind kind, Set* set) : kind_(kind), set_(set) {}
  WaitResultKind kind() const { return kind_; }
  Set& get_wait_set() const
  {
    if (kind_ != WaitResultKind::Ready)
      throw std::runtime_error("cannot access wait set when the result was not ready");
    return *set_;
  }

private:
  WaitResultKind kind_;
  Set* set_;
};

class WaitSet
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSet)
  struct SubscriptionEntry
  {
    SubscriptionBase::SharedPtr subscription;
    SubscriptionWaitSetMask mask;
    SubscriptionEntry(SubscriptionBase::SharedPtr subscription = nullptr, const SubscriptionWaitSetMask& mask = {})
      : subscription(std::move(subscription)), mask(mask)
    {
    }
  };
  struct WaitableEntry
  {
  };
  explicit WaitSet(const std::vector<SubscriptionEntry>& subscriptions = {},
      const std::vector<GuardCondition::SharedPtr>& guard_conditions = {},
      const std::vector<TimerBase::SharedPtr>& timers = {}, const std::vector<ClientBase::SharedPtr>& clients = {},
      const std::vector<ServiceBase::SharedPtr>& services = {}, const std::vector<WaitableEntry>& = {},
      Context::SharedPtr = contexts::get_global_default_context())
    : guard_conditions_(guard_conditions), timers_(timers), clients_(clients), services_(services)
  {
    for (const SubscriptionEntry& each : subscriptions)
      subscriptions_.push_back(each.subscription);
  }
  RCLCPP_DISABLE_COPY(WaitSet)
  void add_subscription(SubscriptionBase::SharedPtr each, SubscriptionWaitSetMask = {}) { add(subscriptions_, each); }
  void remove_subscription(SubscriptionBase::SharedPtr each, SubscriptionWaitSetMask = {})
  {
    remove(subscriptions_, each, "subscription");
  }
  void add_guard_condition(GuardCondition::SharedPtr each) { add(guard_conditions_, each); }
  void remove_guard_condition(GuardCondition::SharedPtr each) { remove(guard_conditions_, each, "guard condition"); }
  void add_timer(TimerBase::SharedPtr each) { add(timers_, each); }
  void remove_timer(TimerBase::SharedPtr each) { remove(timers_, each, "timer"); }
  void add_client(ClientBase::SharedPtr each) { add(clients_, each); }
  void remove_client(ClientBase::SharedPtr each) { remove(clients_, each, "client"); }
  void add_service(ServiceBase::SharedPtr each) { add(services_, each); }
  void remove_service(ServiceBase::SharedPtr each) { remove(services_, each, "service"); }
  const rcl_wait_set_t& get_rcl_wait_set() const { return ready_; }
  void prune_deleted_entities() {}
  template<class Rep = std::int64_t, class Period = std::milli>
  WaitResult<WaitSet> wait(std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return {wait_nanoseconds(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout)), this};
  }

private:
  template<class T>
  static void add(std::vector<std::shared_ptr<T>>& all, const std::shared_ptr<T>& one)
  {
    if (!one)
      throw std::invalid_argument("nullptr given");
    all.push_back(one);
  }
  template<class T>
  static void remove(std::vector<std::shared_ptr<T>>& all, const std::shared_ptr<T>& one, const char* what)
  {
    for (auto each = all.begin(); each != all.end(); each++)
      if (*each == one)
      {
        all.erase(each);
        return;
      }
    throw std::runtime_error(std::string(what) + " not in wait set");
  }
  WaitResultKind wait_nanoseconds(std::chrono::nanoseconds timeout);
  // See what is ready; return when something will be.
  std::int64_t look();
  std::vector<SubscriptionBase::SharedPtr> subscriptions_;
  std::vector<GuardCondition::SharedPtr> guard_conditions_;
  std::vector<TimerBase::SharedPtr> timers_;
  std::vector<ClientBase::SharedPtr> clients_;
  std::vector<ServiceBase::SharedPtr> services_;
  rcl_wait_set_t ready_;
};
using ThreadSafeWaitSet = WaitSet;

// Its members are given as arrays, and stay the same.
template<std::size_t subscriptions, std::size_t guard_conditions, std::size_t timers, std::size_t clients,
    std::size_t services, std::size_t waitables>
class StaticWaitSet : public WaitSet
{
public:
  explicit StaticWaitSet(const std::array<SubscriptionEntry, subscriptions>& those = {},
      const std::array<GuardCondition::SharedPtr, guard_conditions>& conditions = {},
      const std::array<TimerBase::SharedPtr, timers>& times = {},
      const std::array<ClientBase::SharedPtr, clients>& asking = {},
      const std::array<ServiceBase::SharedPtr, services>& answering = {},
      const std::array<WaitableEntry, waitables>& = {},
      Context::SharedPtr = contexts::get_global_default_context())
    : WaitSet({those.begin(), those.end()}, {conditions.begin(), conditions.end()}, {times.begin(), times.end()},
          {asking.begin(), asking.end()}, {answering.begin(), answering.end()})
  {
  }
};

namespace detail
{
// Wait until something is due; return false if the time is over before that (ns; negative: never), or the context.
bool wait_for(const Callable& callable, const Context& context, std::int64_t timeout);
}  // namespace detail

template<class M, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(M& message, std::shared_ptr<Subscription<M>> subscription, Context::SharedPtr context,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  std::int64_t ns = std::chrono::duration_cast<std::chrono::nanoseconds>(timeout).count();
  MessageInfo info;
  return detail::wait_for(*subscription, *context, ns) && subscription->take(message, info);
}
template<class M, class Rep = std::int64_t, class Period = std::milli>
bool wait_for_message(M& message, std::shared_ptr<Node> node, const std::string& topic,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  auto subscription = node->create_subscription<M>(topic, 1, [](std::shared_ptr<const M>) {});
  return wait_for_message(message, subscription, node->get_node_options().context(), timeout);
}
}  // namespace rclcpp

#endif
