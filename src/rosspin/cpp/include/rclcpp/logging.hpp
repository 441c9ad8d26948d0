// Loggers of rclcpp, and the macros that log.
#ifndef ROSSPIN_RCLCPP_LOGGING_HPP
#define ROSSPIN_RCLCPP_LOGGING_HPP

#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

#include "rclcpp/time.hpp"
#include "rcutils/logging.h"
#include "rosspin/format.h"

namespace rclcpp
{
class Node;

class Logger
{
public:
  enum class Level
  {
    Unset = RCUTILS_LOG_SEVERITY_UNSET,
    Debug = RCUTILS_LOG_SEVERITY_DEBUG,
    Info = RCUTILS_LOG_SEVERITY_INFO,
    Warn = RCUTILS_LOG_SEVERITY_WARN,
    Error = RCUTILS_LOG_SEVERITY_ERROR,
    Fatal = RCUTILS_LOG_SEVERITY_FATAL,
  };
  Logger(const Logger&) = default;
  Logger& operator=(const Logger&) = default;
  const char* get_name() const { return name_.c_str(); }
  Logger get_child(const std::string& suffix) const;
  void set_level(Level level) { (void)rcutils_logging_set_logger_level(get_name(), static_cast<int>(level)); }
  Level get_effective_level() const
  {
    return static_cast<Level>(rcutils_logging_get_logger_effective_level(get_name()));
  }

private:
  explicit Logger(const std::string& name) : name_(name) {}
  friend Logger get_logger(const std::string& name);
  std::string name_;
};

inline Logger get_logger(const std::string& name) { return Logger(name); }
std::filesystem::path get_logging_directory();

namespace detail
{
struct Place
{
  const char* function;
  const char* file;
  int line;
};
bool logs(int severity, const char* name);
void log(int severity, const char* name, const Place& place, const std::string& text);
template<class... Values>
__attribute__((format(printf, 4, 5))) void log(
    int severity, const char* name, const Place& place, const char* format, Values... values)
{
  log(severity, name, place, rosspin::formatted(format, {rosspin::Argument(values)...}));
}

// Whether a line may log that logs at most once in so many milliseconds; `last` is when it did (ns).
template<class Clock>
bool throttled(Clock& clock, double milliseconds, std::optional<std::int64_t>& last)
{
  std::int64_t now = clock.now().nanoseconds();
  if (!last && clock.ros_time_is_active())
    last = 0;
  if (last && now < *last + static_cast<std::int64_t>(milliseconds) * 1'000'000)
    return false;
  last = now;
  return true;
}
}  // namespace detail
}  // namespace rclcpp

#define ROSSPIN_PLACE (::rclcpp::detail::Place{__func__, __FILE__, __LINE__})
#define ROSSPIN_IS_LOGGER(logger)                                                                                      \
  static_assert(std::is_same_v<std::remove_cv_t<std::remove_reference_t<decltype(logger)>>, ::rclcpp::Logger>,         \
      "First argument to logging macros must be an rclcpp::Logger")
#define ROSSPIN_LOG(condition, severity, logger, ...)                                                                  \
  do                                                                                                                   \
  {                                                                                                                    \
    ROSSPIN_IS_LOGGER(logger);                                                                                         \
    if (::rclcpp::detail::logs(severity, (logger).get_name()) && (condition))                                          \
      ::rclcpp::detail::log(severity, (logger).get_name(), ROSSPIN_PLACE, __VA_ARGS__);                                \
  } while (false)
// As in rclcpp, the values are written even if nothing is logged.
#define ROSSPIN_LOG_STREAM(condition, severity, logger, values)                                                        \
  do                                                                                                                   \
  {                                                                                                                    \
    ROSSPIN_IS_LOGGER(logger);                                                                                         \
    std::stringstream rosspin_stream;                                                                                  \
    rosspin_stream << values;                                                                                          \
    if (::rclcpp::detail::logs(severity, (logger).get_name()) && (condition))                                          \
      ::rclcpp::detail::log(severity, (logger).get_name(), ROSSPIN_PLACE, rosspin_stream.str());                       \
  } while (false)
// Each line of the node has state of its own.
#define ROSSPIN_ONCE                                                                                                   \
  ([] {                                                                                                                \
    static bool first = true;                                                                                          \
    return first ? first = false, true : false;                                                                        \
  }())
#define ROSSPIN_SKIPFIRST (!ROSSPIN_ONCE)
#define ROSSPIN_THROTTLE(clock, duration)                                                                              \
  ([](auto& rosspin_clock, double rosspin_duration) {                                                                  \
    static std::optional<std::int64_t> last;                                                                           \
    return ::rclcpp::detail::throttled(rosspin_clock, rosspin_duration, last);                                         \
  }(clock, duration))

// RCLCPP_DEBUG, RCLCPP_INFO_STREAM_THROTTLE and all the others.
#include "rclcpp/logging_macros.hpp"

#endif
