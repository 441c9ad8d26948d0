// A stand-in for roscpp on the run's clock.
#ifndef ROSSPIN_ROS_ROS_H
#define ROSSPIN_ROS_ROS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boost/array.hpp"
#include "boost/bind.hpp"
#include "boost/shared_ptr.hpp"
#include "boost/thread.hpp"
#include "ros/console.h"
#include "ros/message.h"
#include "ros/time.h"
#include "rosspin/host.h"

#define ROS_VERSION_MAJOR 1
#define ROS_VERSION_MINOR 15
#define ROS_VERSION_PATCH 15
#define ROS_VERSION_COMBINED(major, minor, patch) (((major) << 20) | ((minor) << 10) | (patch))
#define ROS_VERSION ROS_VERSION_COMBINED(ROS_VERSION_MAJOR, ROS_VERSION_MINOR, ROS_VERSION_PATCH)
#define ROS_VERSION_GE(a, b, c, d, e, f) (ROS_VERSION_COMBINED(a, b, c) >= ROS_VERSION_COMBINED(d, e, f))
#define ROS_VERSION_MINIMUM(a, b, c) ROS_VERSION_GE(1, 15, 15, a, b, c)

namespace ros
{
// --- errors ---

#define ROSSPIN_EXCEPTION(Name)                                                                                        \
  class Name : public Exception                                                                                        \
  {                                                                                                                    \
  public:                                                                                                              \
    using Exception::Exception;                                                                                        \
  }
ROSSPIN_EXCEPTION(InvalidNodeNameException);
ROSSPIN_EXCEPTION(InvalidNameException);
ROSSPIN_EXCEPTION(InvalidParameterException);
ROSSPIN_EXCEPTION(ConflictingSubscriptionException);
ROSSPIN_EXCEPTION(InvalidPortException);
#undef ROSSPIN_EXCEPTION

// --- the node ---

typedef std::map<std::string, std::string> M_string;
typedef std::vector<std::string> V_string;
typedef std::pair<std::string, std::string> StringPair;
typedef std::vector<StringPair> VP_string;
typedef std::set<std::string> S_string;
typedef boost::shared_ptr<void const> VoidConstPtr;
typedef boost::shared_ptr<void> VoidPtr;
typedef boost::weak_ptr<void const> VoidConstWPtr;

namespace init_options
{
enum InitOption
{
  NoSigintHandler = 1,
  AnonymousName = 2,
  NoRosout = 4,
  NoSimTime = 8,
};
}
typedef init_options::InitOption InitOption;

void init(int& argc, char** argv, const std::string& name, std::uint32_t options = 0);
void init(const M_string& remappings, const std::string& name, std::uint32_t options = 0);
void init(const VP_string& remappings, const std::string& name, std::uint32_t options = 0);
bool isInitialized();
void removeROSArgs(int argc, const char* const* argv, V_string& out);
void start();
bool isStarted();
bool ok();
bool isShuttingDown();
void shutdown();
void requestShutdown();
void waitForShutdown();
void spinOnce();

namespace names
{
std::string clean(const std::string& name);
std::string append(const std::string& left, const std::string& right);
std::string resolve(const std::string& name, bool remap = true);
std::string resolve(const std::string& ns, const std::string& name, bool remap = true);
std::string remap(const std::string& name);
std::string parentNamespace(const std::string& name);
bool validate(const std::string& name, std::string& error);
const M_string& getRemappings();
}  // namespace names

namespace this_node
{
const std::string& getName();
const std::string& getNamespace();
void getAdvertisedTopics(V_string& topics);
void getSubscribedTopics(V_string& topics);
}  // namespace this_node

// --- callbacks ---

class CallbackInterface
{
public:
  enum CallResult
  {
    Success,
    TryAgain,
    Invalid
  };
  virtual ~CallbackInterface() {}
  virtual CallResult call() = 0;
  virtual bool ready() { return true; }
};
typedef boost::shared_ptr<CallbackInterface> CallbackInterfacePtr;

class CallbackQueueInterface
{
public:
  virtual ~CallbackQueueInterface() {}
  virtual void addCallback(const CallbackInterfacePtr& callback, std::uint64_t owner = 0) = 0;
  virtual void removeByID(std::uint64_t owner) = 0;
};

class CallbackQueue : public CallbackQueueInterface
{
public:
  enum CallOneResult
  {
    Called,
    TryAgain,
    Disabled,
    Empty
  };
  explicit CallbackQueue(bool enabled = true) : enabled_(enabled) {}
  void addCallback(const CallbackInterfacePtr& callback, std::uint64_t owner = 0) override;
  void removeByID(std::uint64_t owner) override;
  CallOneResult callOne() { return callOne(WallDuration()); }
  CallOneResult callOne(WallDuration timeout);
  CallOneResult callOne(const rosspin::Due& until);
  void callAvailable() { callAvailable(WallDuration()); }
  void callAvailable(WallDuration timeout);
  void callAvailable(const rosspin::Due& until);
  bool empty();
  bool isEmpty() { return empty(); }
  void clear() { waiting_.clear(); }
  void enable() { enabled_ = true; }
  void disable() { enabled_ = false; }
  bool isEnabled() { return enabled_; }

private:
  // Wait until a callback is there, until a time (ns), or until the node shuts down.
  bool await(const rosspin::Due& until);
  struct Entry
  {
    CallbackInterfacePtr callback;
    std::uint64_t owner;
  };
  std::list<Entry>::iterator first();  // that can be called now
  std::list<Entry> waiting_;
  std::vector<std::list<Entry>*> calling_;  // those that callAvailable has taken, innermost last
  bool enabled_;
};
typedef boost::shared_ptr<CallbackQueue> CallbackQueuePtr;

CallbackQueue* getGlobalCallbackQueue();

class Spinner
{
public:
  virtual ~Spinner() {}
  virtual void spin(CallbackQueue* queue = nullptr) = 0;
};

class SingleThreadedSpinner : public Spinner
{
public:
  void spin(CallbackQueue* queue = nullptr) override;
};

void spin();
void spin(Spinner& spinner);

namespace detail
{
// An end of a topic: it lives as long as one of the handles to it does, unless the node handle is shut down.
class Kept
{
public:
  virtual ~Kept() {}
  virtual void end() = 0;
};

// An object that callbacks belong to: they are called only as long as it lives.
class Tracked
{
public:
  Tracked() = default;
  Tracked(const VoidConstPtr& object) : object_(object), tracks_(static_cast<bool>(object)) {}
  bool lives(VoidConstPtr& held) const { return !tracks_ || (held = object_.lock()); }

private:
  VoidConstWPtr object_;
  bool tracks_ = false;
};

struct Called
{
  std::int64_t last_expected = 0, last_real = 0, last_expired = 0, expected = 0, real = 0, expired = 0, duration = 0;
};

// A timer, by the rules of roscpp's timer manager.
class TimerImpl : public rosspin::Ticking
{
public:
  TimerImpl(std::int64_t period, std::function<void(const Called&)> callback, const std::string& name, Tracked tracked,
      CallbackQueueInterface* queue, bool oneshot, std::int64_t (*clock)());
  ~TimerImpl() override;
  void start();
  void stop();
  bool pending() const;
  std::vector<std::pair<std::int64_t, std::int64_t>> coming() const override;
  void set_period(std::int64_t period, bool reset);
  bool started = false;
  std::int64_t period;
  struct Run;

private:
  void end();
  std::shared_ptr<const std::function<void(const Called&)>> callback_;
  std::string name_;
  Tracked tracked_;
  CallbackQueueInterface* queue_;
  bool oneshot_;
  std::int64_t (*clock_)();
  boost::shared_ptr<Run> run_;
};

template<class T, class D>
struct Event
{
  T last_expected, last_real, last_expired, current_expected, current_real, current_expired;
  struct
  {
    WallDuration last_duration;
  } profile;

  static Event of(const Called& called)
  {
    Event event;
    auto time = [](std::int64_t ns) { return T().fromNSec(ns); };
    event.last_expected = time(called.last_expected);
    event.last_real = time(called.last_real);
    event.last_expired = time(called.last_expired);
    event.current_expected = time(called.expected);
    event.current_real = time(called.real);
    event.current_expired = time(called.expired);
    event.profile.last_duration = WallDuration().fromNSec(called.duration);
    return event;
  }
};

// A handle to a timer; its copies are handles to the same one, which ends with the last of them.
template<class D>
class TimerHandle
{
public:
  TimerHandle() = default;
  explicit TimerHandle(boost::shared_ptr<TimerImpl> impl) : impl_(std::move(impl)) {}
  void start() const
  {
    if (impl_)
      impl_->start();
  }
  void stop() const
  {
    if (impl_)
      impl_->stop();
  }
  bool hasPending() const { return impl_ && impl_->pending(); }
  bool hasStarted() const { return impl_ && impl_->started; }
  void setPeriod(const D& period, bool reset = true)
  {
    if (impl_)
      impl_->set_period(period.toNSec(), reset);
  }
  bool isValid() const { return static_cast<bool>(impl_); }
  explicit operator bool() const { return isValid(); }
  operator void*() const { return impl_.get(); }
  bool operator<(const TimerHandle& other) const { return impl_ < other.impl_; }
  bool operator==(const TimerHandle& other) const { return impl_ == other.impl_; }
  bool operator!=(const TimerHandle& other) const { return impl_ != other.impl_; }

private:
  boost::shared_ptr<TimerImpl> impl_;
};
}  // namespace detail

struct TimerEvent : detail::Event<Time, Duration>
{
  TimerEvent() = default;
  explicit TimerEvent(const detail::Called& called) : Event(of(called)) {}
};
struct WallTimerEvent : detail::Event<WallTime, WallDuration>
{
  WallTimerEvent() = default;
  explicit WallTimerEvent(const detail::Called& called) : Event(of(called)) {}
};
struct SteadyTimerEvent : detail::Event<SteadyTime, WallDuration>
{
  SteadyTimerEvent() = default;
  explicit SteadyTimerEvent(const detail::Called& called) : Event(of(called)) {}
};
typedef boost::function<void(const TimerEvent&)> TimerCallback;
typedef boost::function<void(const WallTimerEvent&)> WallTimerCallback;
typedef boost::function<void(const SteadyTimerEvent&)> SteadyTimerCallback;

class Timer : public detail::TimerHandle<Duration>
{
public:
  using TimerHandle::TimerHandle;
};
class WallTimer : public detail::TimerHandle<WallDuration>
{
public:
  using TimerHandle::TimerHandle;
};
class SteadyTimer : public detail::TimerHandle<WallDuration>
{
public:
  using TimerHandle::TimerHandle;
};

namespace detail
{
template<class D, class Callback>
struct TimerOptionsOf
{
  TimerOptionsOf() = default;
  TimerOptionsOf(D period, const Callback& callback, CallbackQueueInterface* callback_queue, bool oneshot = false,
      bool autostart = true)
    : period(period), callback(callback), callback_queue(callback_queue), oneshot(oneshot), autostart(autostart)
  {
  }
  D period;
  Callback callback;
  CallbackQueueInterface* callback_queue = nullptr;
  VoidConstPtr tracked_object;
  bool oneshot = false, autostart = true;
};
}  // namespace detail
typedef detail::TimerOptionsOf<Duration, TimerCallback> TimerOptions;
typedef detail::TimerOptionsOf<WallDuration, WallTimerCallback> WallTimerOptions;
typedef detail::TimerOptionsOf<WallDuration, SteadyTimerCallback> SteadyTimerOptions;

// What this lacks: named where a node says it, or else when the node gets there.
#define ROSSPIN_NOT_SIMULATED(name)                                                                                    \
  __attribute__((unavailable(name " is not simulated; run this node on a real ROS")))

namespace detail
{
struct Spinning;
}

// Its threads call what comes.
class AsyncSpinner
{
public:
  explicit AsyncSpinner(std::uint32_t threads, CallbackQueue* queue = nullptr);
  bool canStart();
  void start();
  void stop();

private:
  boost::shared_ptr<detail::Spinning> spinning_;
};

class MultiThreadedSpinner : public Spinner
{
public:
  explicit MultiThreadedSpinner(std::uint32_t threads = 0) : threads_(threads) {}
  void spin(CallbackQueue* queue = nullptr) override;

private:
  std::uint32_t threads_;
};
}  // namespace ros

#include "ros/node_handle.h"

#endif
