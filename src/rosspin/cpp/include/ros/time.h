// Times, durations and rates of roscpp, on the run's clock.
#ifndef ROSSPIN_ROS_TIME_H
#define ROSSPIN_ROS_TIME_H

#include <cmath>
#include <cstdint>
#include <iostream>
#include <stdexcept>
#include <string>

#include "rosspin/host.h"

namespace ros
{
class Exception : public std::runtime_error
{
public:
  Exception(const std::string& what) : std::runtime_error(what) {}
};

class TimeNotInitializedException : public Exception
{
public:
  TimeNotInitializedException()
    : Exception("Cannot use ros::Time::now() before the first NodeHandle has been created or ros::start() has been "
                "called.  If this is a standalone app or test that just uses ros::Time and does not communicate over "
                "ROS, you may also call ros::Time::init()")
  {
  }
};

class Duration;
class WallDuration;
class Time;
class WallTime;
class SteadyTime;

namespace detail
{
std::int64_t checked_duration(std::int64_t ns);
std::int64_t checked_time(std::int64_t ns);
std::int64_t from_seconds(double seconds, const char* what, std::int64_t least, std::int64_t most);
std::ostream& print(std::ostream& stream, std::int64_t ns);
std::int64_t now(Time*);
std::int64_t now(WallTime*);
std::int64_t now(SteadyTime*);
template<class T>
std::int64_t time_of()
{
  return now(static_cast<T*>(nullptr));
}
bool sleep_for(const Duration*, std::int64_t ns);
bool sleep_for(const WallDuration*, std::int64_t ns);
bool sleep_until(Time*, std::int64_t ns);
bool sleep_until(WallTime*, std::int64_t ns);
bool sleep_until(SteadyTime*, std::int64_t ns);
}  // namespace detail

template<class T>
class DurationBase
{
public:
  std::int32_t sec = 0, nsec = 0;

  DurationBase() = default;
  DurationBase(std::int32_t seconds, std::int32_t nanoseconds)
  {
    fromNSec(seconds * std::int64_t(1'000'000'000) + nanoseconds);
  }
  explicit DurationBase(double seconds) { fromSec(seconds); }

  T operator+(const T& other) const { return T().fromNSec(toNSec() + other.toNSec()); }
  T operator-(const T& other) const { return T().fromNSec(toNSec() - other.toNSec()); }
  T operator-() const { return T().fromNSec(-toNSec()); }
  T operator*(double factor) const { return T(toSec() * factor); }
  T operator/(double divisor) const { return T(toSec() / divisor); }
  T& operator+=(const T& other) { return fromNSec(toNSec() + other.toNSec()); }
  T& operator-=(const T& other) { return fromNSec(toNSec() - other.toNSec()); }
  T& operator*=(double factor) { return fromSec(toSec() * factor); }
  bool operator==(const T& other) const { return toNSec() == other.toNSec(); }
  bool operator!=(const T& other) const { return toNSec() != other.toNSec(); }
  bool operator<(const T& other) const { return toNSec() < other.toNSec(); }
  bool operator>(const T& other) const { return toNSec() > other.toNSec(); }
  bool operator<=(const T& other) const { return toNSec() <= other.toNSec(); }
  bool operator>=(const T& other) const { return toNSec() >= other.toNSec(); }

  double toSec() const { return static_cast<double>(sec) + 1e-9 * static_cast<double>(nsec); }
  std::int64_t toNSec() const { return sec * std::int64_t(1'000'000'000) + nsec; }
  T& fromSec(double seconds)
  {
    return set(detail::from_seconds(seconds, "Duration", INT32_MIN, INT32_MAX));
  }
  T& fromNSec(std::int64_t ns) { return set(detail::checked_duration(ns)); }
  bool isZero() const { return sec == 0 && nsec == 0; }
  bool sleep() const { return detail::sleep_for(static_cast<const T*>(this), toNSec()); }

private:
  T& set(std::int64_t ns)
  {
    sec = static_cast<std::int32_t>(ns / 1'000'000'000 - (ns % 1'000'000'000 < 0));
    nsec = static_cast<std::int32_t>(ns - sec * std::int64_t(1'000'000'000));
    return static_cast<T&>(*this);
  }
};

class Rate;

class Duration : public DurationBase<Duration>
{
public:
  using DurationBase::DurationBase;
  Duration() = default;
  Duration(const Rate& rate);
  static const Duration MAX, MIN, ZERO, DAY, HOUR, MINUTE, SECOND, MILLISECOND, MICROSECOND, NANOSECOND;
};

class WallDuration : public DurationBase<WallDuration>
{
public:
  using DurationBase::DurationBase;
  WallDuration() = default;
  explicit WallDuration(const Rate& rate);
  static const WallDuration MAX, MIN, ZERO, DAY, HOUR, MINUTE, SECOND, MILLISECOND, MICROSECOND, NANOSECOND;
};

extern const Duration DURATION_MAX;
extern const Duration DURATION_MIN;

template<class T>
std::ostream& operator<<(std::ostream& stream, const DurationBase<T>& duration)
{
  return detail::print(stream, duration.toNSec());
}

template<class T, class D>
class TimeBase
{
public:
  std::uint32_t sec = 0, nsec = 0;

  TimeBase() = default;
  TimeBase(std::uint32_t seconds, std::uint32_t nanoseconds)
  {
    set(detail::checked_time(seconds * std::int64_t(1'000'000'000) + nanoseconds));
  }
  explicit TimeBase(double seconds) { fromSec(seconds); }

  D operator-(const T& other) const
  {
    return D().fromNSec(static_cast<std::int64_t>(toNSec()) - static_cast<std::int64_t>(other.toNSec()));
  }
  T operator+(const D& duration) const { return moved(duration.toNSec()); }
  T operator-(const D& duration) const { return moved(-duration.toNSec()); }
  T& operator+=(const D& duration) { return static_cast<T&>(*this) = moved(duration.toNSec()); }
  T& operator-=(const D& duration) { return static_cast<T&>(*this) = moved(-duration.toNSec()); }
  bool operator==(const T& other) const { return toNSec() == other.toNSec(); }
  bool operator!=(const T& other) const { return toNSec() != other.toNSec(); }
  bool operator<(const T& other) const { return toNSec() < other.toNSec(); }
  bool operator>(const T& other) const { return toNSec() > other.toNSec(); }
  bool operator<=(const T& other) const { return toNSec() <= other.toNSec(); }
  bool operator>=(const T& other) const { return toNSec() >= other.toNSec(); }

  double toSec() const { return static_cast<double>(sec) + 1e-9 * static_cast<double>(nsec); }
  std::uint64_t toNSec() const { return sec * std::uint64_t(1'000'000'000) + nsec; }
  T& fromSec(double seconds) { return set(detail::from_seconds(seconds, "Time", 0, UINT32_MAX)); }
  T& fromNSec(std::uint64_t ns) { return set(detail::checked_time(static_cast<std::int64_t>(ns))); }
  bool isZero() const { return sec == 0 && nsec == 0; }
  bool is_zero() const { return isZero(); }

private:
  T moved(std::int64_t ns) const
  {
    T time;
    time.set(detail::checked_time(static_cast<std::int64_t>(toNSec()) + ns));
    return time;
  }
  T& set(std::int64_t ns)
  {
    sec = static_cast<std::uint32_t>(ns / 1'000'000'000);
    nsec = static_cast<std::uint32_t>(ns % 1'000'000'000);
    return static_cast<T&>(*this);
  }
};

class Time : public TimeBase<Time, Duration>
{
public:
  using TimeBase::TimeBase;
  Time() = default;
  static const Time MIN, MAX, ZERO, UNINITIALIZED;
  static Time now() { return Time().fromNSec(detail::now(static_cast<Time*>(nullptr))); }
  static bool sleepUntil(const Time& end) { return detail::sleep_until(static_cast<Time*>(nullptr), end.toNSec()); }
  static void init();
  static void shutdown();
  static void setNow(const Time& now);
  static bool useSystemTime() { return !isSimTime(); }
  static bool isSimTime();
  static bool isSystemTime() { return !isSimTime(); }
  static bool isValid();
  static bool waitForValid(const WallDuration& timeout = WallDuration());
};

class WallTime : public TimeBase<WallTime, WallDuration>
{
public:
  using TimeBase::TimeBase;
  WallTime() = default;
  static const WallTime MIN, MAX, ZERO;
  static WallTime now() { return WallTime().fromNSec(detail::now(static_cast<WallTime*>(nullptr))); }
  static bool sleepUntil(const WallTime& end)
  {
    return detail::sleep_until(static_cast<WallTime*>(nullptr), end.toNSec());
  }
  static bool isSystemTime() { return true; }
};

class SteadyTime : public TimeBase<SteadyTime, WallDuration>
{
public:
  using TimeBase::TimeBase;
  SteadyTime() = default;
  static const SteadyTime MIN, MAX, ZERO;
  static SteadyTime now() { return SteadyTime().fromNSec(detail::now(static_cast<SteadyTime*>(nullptr))); }
  static bool sleepUntil(const SteadyTime& end)
  {
    return detail::sleep_until(static_cast<SteadyTime*>(nullptr), end.toNSec());
  }
};

extern const Time TIME_MAX;
extern const Time TIME_MIN;

template<class T, class D>
std::ostream& operator<<(std::ostream& stream, const TimeBase<T, D>& time)
{
  return detail::print(stream, static_cast<std::int64_t>(time.toNSec()));
}

namespace detail
{
// What a Rate, a WallRate have in common: passes of a loop that should begin at regular times.
class Passes : rosspin::Loop
{
public:
  Passes(std::int64_t period, bool wall);
  bool sleep();
  void reset() { mark_ = time(); }
  std::int64_t period() const { return period_; }
  std::int64_t cycle = 0;

private:
  std::int64_t time() const override;
  std::int64_t wake(std::int64_t& mark, std::int64_t now) const override;
  bool wall_;
};
}  // namespace detail

class Rate
{
public:
  Rate(double frequency) : passes_(Duration(1.0 / frequency).toNSec(), false) {}
  explicit Rate(const Duration& period) : passes_(period.toNSec(), false) {}
  bool sleep() { return passes_.sleep(); }
  void reset() { passes_.reset(); }
  Duration cycleTime() const { return Duration().fromNSec(passes_.cycle); }
  Duration expectedCycleTime() const { return Duration().fromNSec(passes_.period()); }

private:
  detail::Passes passes_;
};

class WallRate
{
public:
  WallRate(double frequency) : passes_(WallDuration(1.0 / frequency).toNSec(), true) {}
  explicit WallRate(const Duration& period) : passes_(period.toNSec(), true) {}
  bool sleep() { return passes_.sleep(); }
  void reset() { passes_.reset(); }
  WallDuration cycleTime() const { return WallDuration().fromNSec(passes_.cycle); }
  WallDuration expectedCycleTime() const { return WallDuration().fromNSec(passes_.period()); }

private:
  detail::Passes passes_;
};

inline Duration::Duration(const Rate& rate) { *this = rate.expectedCycleTime(); }
inline WallDuration::WallDuration(const Rate& rate) { fromNSec(rate.expectedCycleTime().toNSec()); }
}  // namespace ros

#endif
