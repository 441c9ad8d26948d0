// From init to shutdown in rclcpp.
#ifndef ROSSPIN_RCLCPP_CONTEXT_HPP
#define ROSSPIN_RCLCPP_CONTEXT_HPP

#include <chrono>
#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"
#include "rosspin/host.h"

namespace rclcpp
{
enum class SignalHandlerOptions
{
  All,
  SigInt,
  SigTerm,
  None,
};

class InitOptions
{
public:
  bool shutdown_on_signal = true;
  InitOptions& auto_initialize_logging(bool initialize)
  {
    logging_ = initialize;
    return *this;
  }
  bool auto_initialize_logging() const { return logging_; }
  std::size_t get_domain_id() const { return domain_; }
  void set_domain_id(std::size_t domain) { domain_ = domain; }
  void use_default_domain_id() {}

private:
  bool logging_ = true;
  std::size_t domain_ = 0;
};

struct ShutdownCallbackHandle
{
  std::weak_ptr<std::function<void()>> callback;
};
using OnShutdownCallbackHandle = ShutdownCallbackHandle;
using PreShutdownCallbackHandle = ShutdownCallbackHandle;

class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)
  using OnShutdownCallback = std::function<void()>;

  Context() = default;
  virtual ~Context() { Context::shutdown("context destructor was called while still not shutdown"); }
  virtual void init(int argc, char const* const* argv, const InitOptions& options = InitOptions());
  bool is_valid() const { return valid_; }
  const InitOptions& get_init_options() const { return options_; }
  std::size_t get_domain_id() const { return options_.get_domain_id(); }
  std::string shutdown_reason() const { return reason_; }
  virtual bool shutdown(const std::string& reason);
  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback)
  {
    add_on_shutdown_callback(callback);
    return callback;
  }
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback)
  {
    return add(after_, std::move(callback));
  }
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle& handle) { return remove(after_, handle); }
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(OnShutdownCallback callback)
  {
    return add(before_, std::move(callback));
  }
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle& handle) { return remove(before_, handle); }
  bool sleep_for(const std::chrono::nanoseconds& length);

  // What follows is not rclcpp's. Its number at the host; negative before init.
  std::int64_t id() const { return id_; }
  // Raises what making anything in it raises, unless it continues.
  void check(const char* what) const;

private:
  typedef std::list<std::shared_ptr<std::function<void()>>> Callbacks;
  static ShutdownCallbackHandle add(Callbacks& all, OnShutdownCallback callback);
  static bool remove(Callbacks& all, const ShutdownCallbackHandle& handle);
  bool valid_ = false;
  std::int64_t id_ = -1;
  InitOptions options_;
  std::string reason_;
  Callbacks before_, after_;
};

std::vector<Context::SharedPtr> get_contexts();

namespace contexts
{
std::shared_ptr<Context> get_global_default_context();
class DefaultContext : public Context
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(DefaultContext)
};
namespace default_context
{
using contexts::get_global_default_context;
}
}  // namespace contexts

void init(int argc, char const* const* argv, const InitOptions& options = InitOptions(),
    SignalHandlerOptions signals = SignalHandlerOptions::All);
std::vector<std::string> init_and_remove_ros_arguments(
    int argc, char const* const* argv, const InitOptions& options = InitOptions());
std::vector<std::string> remove_ros_arguments(int argc, char const* const* argv);
bool install_signal_handlers(SignalHandlerOptions options = SignalHandlerOptions::All);
bool signal_handlers_installed();
SignalHandlerOptions get_current_signal_handler_options();
bool uninstall_signal_handlers();
bool ok(Context::SharedPtr context = nullptr);
bool shutdown(Context::SharedPtr context = nullptr, const std::string& reason = "user called rclcpp::shutdown()");
void on_shutdown(std::function<void()> callback, Context::SharedPtr context = nullptr);
bool sleep_for(const std::chrono::nanoseconds& length, Context::SharedPtr context = nullptr);
}  // namespace rclcpp

#endif
