// Times, durations, clocks and rates of rclcpp, on the run's clock.
#ifndef ROSSPIN_RCLCPP_TIME_HPP
#define ROSSPIN_RCLCPP_TIME_HPP

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "rclcpp/macros.hpp"
#include "rmw/types.h"
#include "rosspin/host.h"

typedef std::int64_t rcl_time_point_value_t;
typedef std::int64_t rcl_duration_value_t;
typedef std::int64_t rcutils_time_point_value_t;
typedef std::int64_t rcutils_duration_value_t;
enum rcl_clock_type_t
{
  RCL_CLOCK_UNINITIALIZED,
  RCL_ROS_TIME,
  RCL_SYSTEM_TIME,
  RCL_STEADY_TIME
};
struct rcl_duration_t
{
  rcl_duration_value_t nanoseconds;
};
enum rcl_clock_change_t
{
  RCL_ROS_TIME_NO_CHANGE = 1,
  RCL_ROS_TIME_ACTIVATED,
  RCL_ROS_TIME_DEACTIVATED,
  RCL_SYSTEM_TIME_NO_CHANGE
};
struct rcl_time_jump_t
{
  rcl_clock_change_t clock_change;
  rcl_duration_t delta;
};
struct rcl_jump_threshold_t
{
  bool on_clock_change;
  rcl_duration_t min_forward, min_backward;
};
#define RCL_S_TO_NS(seconds) ((seconds) * (1000LL * 1000LL * 1000LL))
#define RCL_MS_TO_NS(milliseconds) ((milliseconds) * (1000LL * 1000LL))
#define RCL_US_TO_NS(microseconds) ((microseconds) * 1000LL)
#define RCL_NS_TO_S(nanoseconds) ((nanoseconds) / (1000LL * 1000LL * 1000LL))
#define RCL_NS_TO_MS(nanoseconds) ((nanoseconds) / (1000LL * 1000LL))
#define RCL_NS_TO_US(nanoseconds) ((nanoseconds) / 1000LL)

namespace rclcpp
{
namespace detail
{
std::int64_t sum(std::int64_t one, std::int64_t other, const char* what = "addition");
std::int64_t difference(std::int64_t one, std::int64_t other, const char* what);
}  // namespace detail

class Duration
{
public:
  Duration(std::int32_t seconds, std::uint32_t nanoseconds) : ns_(seconds * 1'000'000'000LL + nanoseconds) {}
  explicit Duration(std::chrono::nanoseconds length) : ns_(length.count()) {}
  template<class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period>& length)
    : ns_(std::chrono::duration_cast<std::chrono::nanoseconds>(length).count())
  {
  }
  Duration(const builtin_interfaces::msg::Duration& message) : Duration(message.sec, message.nanosec) {}
  explicit Duration(const rcl_duration_t& duration) : ns_(duration.nanoseconds) {}
  Duration() : ns_(0) {}
  operator builtin_interfaces::msg::Duration() const;

  bool operator==(const Duration& other) const { return ns_ == other.ns_; }
  bool operator!=(const Duration& other) const { return ns_ != other.ns_; }
  bool operator<(const Duration& other) const { return ns_ < other.ns_; }
  bool operator<=(const Duration& other) const { return ns_ <= other.ns_; }
  bool operator>(const Duration& other) const { return ns_ > other.ns_; }
  bool operator>=(const Duration& other) const { return ns_ >= other.ns_; }
  Duration operator+(const Duration& other) const { return from_nanoseconds(detail::sum(ns_, other.ns_)); }
  Duration operator-(const Duration& other) const
  {
    return from_nanoseconds(detail::difference(ns_, other.ns_, "duration subtraction"));
  }
  Duration operator*(double scale) const;
  Duration& operator+=(const Duration& other) { return *this = *this + other; }
  Duration& operator-=(const Duration& other) { return *this = *this - other; }
  Duration& operator*=(double scale) { return *this = *this * scale; }

  static Duration max() { return Duration(INT32_MAX, 999999999); }
  static Duration from_seconds(double seconds) { return from_nanoseconds(static_cast<std::int64_t>(seconds * 1e9)); }
  static Duration from_nanoseconds(std::int64_t ns) { return Duration(std::chrono::nanoseconds(ns)); }
  static Duration from_rmw_time(rmw_time_t time) { return from_nanoseconds(time.sec * 1'000'000'000LL + time.nsec); }
  rmw_time_t to_rmw_time() const;
  std::int64_t nanoseconds() const { return ns_; }
  double seconds() const { return std::chrono::duration<double>(std::chrono::nanoseconds(ns_)).count(); }
  template<class Length>
  Length to_chrono() const
  {
    return std::chrono::duration_cast<Length>(std::chrono::nanoseconds(ns_));
  }

private:
  std::int64_t ns_;
};

class Time
{
public:
  Time(std::int32_t seconds, std::uint32_t nanoseconds, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  explicit Time(std::int64_t nanoseconds = 0, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME)
    : ns_(nanoseconds), type_(clock_type)
  {
  }
  Time(const builtin_interfaces::msg::Time& message, rcl_clock_type_t clock_type = RCL_ROS_TIME)
    : Time(message.sec, message.nanosec, clock_type)
  {
  }
  operator builtin_interfaces::msg::Time() const;
  Time& operator=(const builtin_interfaces::msg::Time& message) { return *this = Time(message); }
  Time(const Time&) = default;
  Time& operator=(const Time&) = default;

  bool operator==(const Time& other) const { return compared(other).ns_ == other.ns_; }
  bool operator!=(const Time& other) const { return compared(other).ns_ != other.ns_; }
  bool operator<(const Time& other) const { return compared(other).ns_ < other.ns_; }
  bool operator<=(const Time& other) const { return compared(other).ns_ <= other.ns_; }
  bool operator>(const Time& other) const { return compared(other).ns_ > other.ns_; }
  bool operator>=(const Time& other) const { return compared(other).ns_ >= other.ns_; }
  Time operator+(const Duration& by) const { return Time(detail::sum(ns_, by.nanoseconds()), type_); }
  Time operator-(const Duration& by) const
  {
    return Time(detail::difference(ns_, by.nanoseconds(), "time subtraction"), type_);
  }
  Duration operator-(const Time& other) const;
  Time& operator+=(const Duration& by) { return *this = *this + by; }
  Time& operator-=(const Duration& by) { return *this = *this - by; }

  std::int64_t nanoseconds() const { return ns_; }
  double seconds() const { return std::chrono::duration<double>(std::chrono::nanoseconds(ns_)).count(); }
  rcl_clock_type_t get_clock_type() const { return type_; }
  static Time max(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) { return Time(INT32_MAX, 999999999, clock_type); }

private:
  const Time& compared(const Time& other) const;
  std::int64_t ns_;
  rcl_clock_type_t type_;
};

inline Time operator+(const Duration& by, const Time& time) { return time + by; }

class Context;
class TimerBase;
namespace contexts
{
std::shared_ptr<Context> get_global_default_context();
}

class JumpHandler
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)
  using pre_callback_t = std::function<void()>;
  using post_callback_t = std::function<void(const rcl_time_jump_t&)>;
  pre_callback_t pre_callback;
  post_callback_t post_callback;
  rcl_jump_threshold_t notice_threshold;
};

class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)
  explicit Clock(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME) : type_(clock_type) {}

  Time now() const { return Time(ns(), type_); }
  bool sleep_until(Time until, std::shared_ptr<Context> context = contexts::get_global_default_context());
  bool sleep_for(Duration length, std::shared_ptr<Context> context = contexts::get_global_default_context())
  {
    return sleep_until(now() + length, context);
  }
  bool started() const { return ns() != 0; }
  bool wait_until_started(std::shared_ptr<Context> context = contexts::get_global_default_context());
  bool wait_until_started(const Duration& timeout,
      std::shared_ptr<Context> context = contexts::get_global_default_context(),
      const Duration& step = Duration(0, 10'000'000));
  void cancel_sleep_or_wait() { cancelled_ = true; }
  bool ros_time_is_active() const { return active_; }
  rcl_clock_type_t get_clock_type() const { return type_; }
  std::mutex& get_clock_mutex() { return mutex_; }
  JumpHandler::SharedPtr create_jump_callback(JumpHandler::pre_callback_t before, JumpHandler::post_callback_t after,
      const rcl_jump_threshold_t& threshold);

  // What follows is not rclcpp's. Its time in ns; when, in the run's time, a time of it comes: never, if that is unknown.
  std::int64_t ns() const;
  std::int64_t in_run(std::int64_t ns) const;
  // Let it follow /clock, or set the time that it follows.
  void follow(bool active);
  void set(std::int64_t ns);
  std::vector<TimerBase*> timers;  // that go by it, if it is ROS's

private:
  // Tell those who want to know it of a jump, before it or after it.
  void tell(const rcl_time_jump_t& jump, bool before);
  rcl_clock_type_t type_;
  bool active_ = false, cancelled_ = false, switched_ = false;
  std::int64_t ros_ = 0;
  std::vector<std::weak_ptr<JumpHandler>> handlers_;
  std::mutex mutex_;
};

class RateBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(RateBase)
  virtual ~RateBase() {}
  virtual bool sleep() = 0;
  virtual rcl_clock_type_t get_type() const = 0;
  virtual void reset() = 0;
};

class Rate : public RateBase, rosspin::Loop
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)
  explicit Rate(double rate, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));
  explicit Rate(const Duration& period, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));
  bool sleep() override;
  bool is_steady() const { return get_type() == RCL_STEADY_TIME; }
  rcl_clock_type_t get_type() const override { return clock_->get_clock_type(); }
  void reset() override { mark_ = clock_->ns(); }
  std::chrono::nanoseconds period() const { return std::chrono::nanoseconds(period_); }

private:
  std::int64_t time() const override { return clock_->ns(); }
  std::int64_t wake(std::int64_t& mark, std::int64_t now) const override;
  Clock::SharedPtr clock_;
};

class WallRate : public Rate
{
public:
  explicit WallRate(double rate) : Rate(rate, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
  explicit WallRate(const Duration& period) : Rate(period, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
};

class ROSRate : public Rate
{
public:
  explicit ROSRate(double rate) : Rate(rate, std::make_shared<Clock>(RCL_ROS_TIME)) {}
  explicit ROSRate(const Duration& period) : Rate(period, std::make_shared<Clock>(RCL_ROS_TIME)) {}
};

template<class Clock = std::chrono::high_resolution_clock>
class GenericRate : public Rate
{
public:
  explicit GenericRate(double rate) : Rate(rate, clock()) {}
  explicit GenericRate(std::chrono::nanoseconds period) : Rate(Duration(period), clock()) {}

private:
  static std::shared_ptr<rclcpp::Clock> clock()
  {
    return std::make_shared<rclcpp::Clock>(Clock::is_steady ? RCL_STEADY_TIME : RCL_SYSTEM_TIME);
  }
};
}  // namespace rclcpp

#endif
