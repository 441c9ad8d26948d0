// Logging of rosconsole, as it looks without a configuration of its own.
#ifndef ROSSPIN_ROS_CONSOLE_H
#define ROSSPIN_ROS_CONSOLE_H

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>

#include "ros/time.h"
#include "rosspin/format.h"

namespace ros
{
namespace console
{
namespace levels
{
enum Level
{
  Debug,
  Info,
  Warn,
  Error,
  Fatal,
  Count
};
}
typedef levels::Level Level;

bool enabled(Level level);
void print(Level level, const std::string& text);
template<class... Values>
__attribute__((format(printf, 2, 3))) void print(Level level, const char* format, Values... values)
{
  print(level, rosspin::formatted(format, {rosspin::Argument(values)...}));
}
// What decides whether a line logs that names it.
class FilterBase
{
public:
  virtual ~FilterBase() {}
  virtual bool isEnabled() { return true; }
};

bool set_logger_level(const std::string& name, Level level);
inline bool get_loggers(std::map<std::string, Level>&) { return true; }
inline void notifyLoggerLevelsChanged() {}

// Whether a line may log that logs at most once in `period` seconds; `last` is when it did, NaN before the first time.
bool throttled(double period, double& last, bool delayed = false);
}  // namespace console
}  // namespace ros

#define ROSCONSOLE_DEFAULT_NAME "ros"
#define ROSSPIN_LOG(condition, level, ...)                                                                             \
  do                                                                                                                   \
  {                                                                                                                    \
    if (::ros::console::enabled(level) && (condition))                                                                 \
      ::ros::console::print(level, __VA_ARGS__);                                                                       \
  } while (false)
#define ROSSPIN_LOG_STREAM(condition, level, values)                                                                   \
  do                                                                                                                   \
  {                                                                                                                    \
    if (::ros::console::enabled(level) && (condition))                                                                 \
    {                                                                                                                  \
      std::stringstream rosspin_stream;                                                                                \
      rosspin_stream << values;                                                                                        \
      ::ros::console::print(level, rosspin_stream.str());                                                              \
    }                                                                                                                  \
  } while (false)
// Each line of the node has state of its own.
#define ROSSPIN_ONCE                                                                                                   \
  ([] {                                                                                                                \
    static bool first = true;                                                                                          \
    return first ? first = false, true : false;                                                                        \
  }())
#define ROSSPIN_THROTTLE(period, delayed)                                                                              \
  ([&] {                                                                                                               \
    static double last = NAN;                                                                                          \
    return ::ros::console::throttled(period, last, delayed);                                                           \
  }())

#define ROSCONSOLE_AUTOINIT static_cast<void>(0)
#define ROS_LOG(level, name, ...) ROSSPIN_LOG(true, level, __VA_ARGS__)
#define ROS_LOG_STREAM(level, name, values) ROSSPIN_LOG_STREAM(true, level, values)
#define ROS_LOG_COND(condition, level, name, ...) ROSSPIN_LOG(condition, level, __VA_ARGS__)
#define ROS_LOG_ONCE(level, name, ...) ROSSPIN_LOG(ROSSPIN_ONCE, level, __VA_ARGS__)
#define ROS_LOG_THROTTLE(period, level, name, ...) ROSSPIN_LOG(ROSSPIN_THROTTLE(period, false), level, __VA_ARGS__)

#define ROS_BREAK() std::abort()
#define ROS_ASSERT(condition)                                                                                          \
  do                                                                                                                   \
  {                                                                                                                    \
    if (!(condition))                                                                                                  \
    {                                                                                                                  \
      ROS_FATAL("ASSERTION FAILED\n\tfile = %s\n\tline = %d\n\tcond = %s\n", __FILE__, __LINE__, #condition);          \
      std::abort();                                                                                                    \
    }                                                                                                                  \
  } while (false)
#define ROS_ASSERT_MSG(condition, ...)                                                                                 \
  do                                                                                                                   \
  {                                                                                                                    \
    if (!(condition))                                                                                                  \
    {                                                                                                                  \
      ROS_FATAL("ASSERTION FAILED\n\tfile = %s\n\tline = %d\n\tcond = %s\n\tmessage = ", __FILE__, __LINE__,           \
          #condition);                                                                                                 \
      ROS_FATAL(__VA_ARGS__);                                                                                          \
      std::abort();                                                                                                    \
    }                                                                                                                  \
  } while (false)
#define ROS_ASSERT_CMD(condition, command)                                                                             \
  do                                                                                                                   \
  {                                                                                                                    \
    if (!(condition))                                                                                                  \
    {                                                                                                                  \
      command;                                                                                                         \
    }                                                                                                                  \
  } while (false)
#define ROS_ISSUE_BREAK() std::abort()

// ROS_DEBUG, ROS_INFO_STREAM_THROTTLE and all the others.
#include "ros/console_macros.h"

#endif
