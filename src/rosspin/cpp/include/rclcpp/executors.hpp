// The executors of rclcpp, and spin.
#ifndef ROSSPIN_RCLCPP_EXECUTORS_HPP
#define ROSSPIN_RCLCPP_EXECUTORS_HPP

#include <future>
#include <mutex>

#include "rclcpp/node.hpp"

namespace rclcpp
{
enum class FutureReturnCode
{
  SUCCESS,
  INTERRUPTED,
  TIMEOUT
};
std::ostream& operator<<(std::ostream& stream, const FutureReturnCode& code);
std::string to_string(const FutureReturnCode& code);

struct ExecutorOptions
{
  Context::SharedPtr context = contexts::get_global_default_context();
  std::size_t max_conditions = 0;
};

class Executor
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Executor)
  typedef node_interfaces::NodeBaseInterface::SharedPtr Base;

  explicit Executor(const ExecutorOptions& options = ExecutorOptions());
  virtual ~Executor();
  RCLCPP_DISABLE_COPY(Executor)

  virtual void spin() = 0;
  virtual void add_node(Base node, bool notify = true);
  virtual void add_node(std::shared_ptr<Node> node, bool notify = true)
  {
    add_node(node->get_node_base_interface(), notify);
  }
  virtual void remove_node(Base node, bool notify = true);
  virtual void remove_node(std::shared_ptr<Node> node, bool notify = true)
  {
    remove_node(node->get_node_base_interface(), notify);
  }
  virtual void add_callback_group(CallbackGroup::SharedPtr group, Base node, bool notify = true);
  virtual void remove_callback_group(CallbackGroup::SharedPtr group, bool notify = true);
  virtual void spin_once(std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  virtual void spin_some(std::chrono::nanoseconds max_duration = std::chrono::nanoseconds(0))
  {
    spin_some(max_duration, false);
  }
  virtual void spin_all(std::chrono::nanoseconds max_duration);
  void spin_node_some(Base node);
  void spin_node_some(std::shared_ptr<Node> node) { spin_node_some(node->get_node_base_interface()); }
  void spin_node_all(Base node, std::chrono::nanoseconds max_duration);
  void spin_node_all(std::shared_ptr<Node> node, std::chrono::nanoseconds max_duration)
  {
    spin_node_all(node->get_node_base_interface(), max_duration);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  void spin_node_once(
      Base node, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    add_node(node, false);
    spin_once(std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
    remove_node(node, false);
  }
  template<class Rep = std::int64_t, class Period = std::milli>
  void spin_node_once(std::shared_ptr<Node> node,
      std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    spin_node_once(node->get_node_base_interface(), timeout);
  }
  template<class Future, class Rep = std::int64_t, class Period = std::milli>
  FutureReturnCode spin_until_future_complete(
      const Future& future, std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return spin_until([&future] { return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready; },
        std::chrono::duration_cast<std::chrono::nanoseconds>(timeout));
  }
  virtual void cancel()
  {
    spinning_ = false;
    rosspin::stir();
  }
  bool is_spinning() const { return spinning_; }

protected:
  struct Spinning;
  // Wait until there are calls to make, for at most a time (ns; negative: for as long as it takes), and take them.
  void wait_for_work(std::int64_t timeout);
  // Make the next of the calls that were taken; return false if none is left.
  bool call_next();
  bool goes_on() const;
  FutureReturnCode spin_until(const std::function<bool()>& is_ready, std::chrono::nanoseconds timeout);
  void spin_some(std::chrono::nanoseconds max_duration, bool exhaustive);
  bool needs_collecting() const { return seen_ != detail::changes; }
  void collect();
  std::int64_t take_due();

  Context::SharedPtr context_;
  bool spinning_ = false, statically_ = false;
  std::vector<std::weak_ptr<detail::Callable>> known_;  // in the order in which they are looked at
  std::vector<detail::Callable*> found_;  // the same ones, as long as nothing has changed
  std::deque<std::shared_ptr<detail::Callable>> taken_;

private:
  std::vector<std::weak_ptr<node_interfaces::NodeBaseInterface>> nodes_;
  std::vector<CallbackGroup::WeakPtr> groups_;  // those that were added by themselves
  std::uint64_t seen_ = 0;
};

namespace executors
{
class SingleThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SingleThreadedExecutor)
  using Executor::Executor;
  void spin() override;
};

// Calls, of what is due, subscriptions before timers.
class StaticSingleThreadedExecutor : public SingleThreadedExecutor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(StaticSingleThreadedExecutor)
  explicit StaticSingleThreadedExecutor(const ExecutorOptions& options = ExecutorOptions())
    : SingleThreadedExecutor(options)
  {
    statically_ = true;
  }
};

// Without a number of threads there are 4, not as many as there are processors.
class MultiThreadedExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)
  explicit MultiThreadedExecutor(const ExecutorOptions& options = ExecutorOptions(), std::size_t threads = 0,
      bool yield_before_execute = false, std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
    : Executor(options), threads_(threads ? threads : 4)
  {
  }
  std::size_t get_number_of_threads() const { return threads_; }
  void spin() override;

private:
  void run();
  std::shared_ptr<detail::Callable> take();
  std::size_t threads_;
  std::mutex mutex_;
};

template<class Future, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_node_until_future_complete(Executor& executor, Executor::Base node, const Future& future,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executor.add_node(node);
  FutureReturnCode code = executor.spin_until_future_complete(future, timeout);
  executor.remove_node(node);
  return code;
}
template<class Future, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_node_until_future_complete(Executor& executor, std::shared_ptr<Node> node, const Future& future,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  return spin_node_until_future_complete(executor, node->get_node_base_interface(), future, timeout);
}
}  // namespace executors

namespace experimental
{
namespace executors
{
// Makes each call that becomes due, in the order in which they do: none is left out because another took long.
class EventsExecutor : public Executor
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)
  using Executor::Executor;
  void spin() override;
  void spin_once(std::chrono::nanoseconds = std::chrono::nanoseconds(-1)) override
  {
    rosspin::not_simulated("rclcpp::experimental::executors::EventsExecutor::spin_once");
  }
  void spin_some(std::chrono::nanoseconds = std::chrono::nanoseconds(0)) override
  {
    rosspin::not_simulated("rclcpp::experimental::executors::EventsExecutor::spin_some");
  }
  void spin_all(std::chrono::nanoseconds) override
  {
    rosspin::not_simulated("rclcpp::experimental::executors::EventsExecutor::spin_all");
  }
};
}  // namespace executors
}  // namespace experimental

void spin(Executor::Base node);
void spin(std::shared_ptr<Node> node);
void spin_some(Executor::Base node);
void spin_some(std::shared_ptr<Node> node);
void spin_all(Executor::Base node, std::chrono::nanoseconds max_duration);
void spin_all(std::shared_ptr<Node> node, std::chrono::nanoseconds max_duration);
template<class AnyNode, class Future, class Rep = std::int64_t, class Period = std::milli>
FutureReturnCode spin_until_future_complete(const std::shared_ptr<AnyNode>& node, const Future& future,
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
{
  executors::SingleThreadedExecutor executor;
  Executor::Base base;
  if constexpr (std::is_same_v<AnyNode, node_interfaces::NodeBaseInterface>)
    base = node;
  else
    base = node->get_node_base_interface();
  return executors::spin_node_until_future_complete(executor, base, future, timeout);
}
}  // namespace rclcpp

#endif
