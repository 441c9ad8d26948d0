#ifndef ROSSPIN_RCUTILS_LOGGING_MACROS_H
#define ROSSPIN_RCUTILS_LOGGING_MACROS_H

#include "rclcpp/logging.hpp"

#define RCUTILS_LOG_DEBUG_NAMED(name, ...) RCLCPP_DEBUG(::rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_INFO_NAMED(name, ...) RCLCPP_INFO(::rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_WARN_NAMED(name, ...) RCLCPP_WARN(::rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_NAMED(name, ...) RCLCPP_ERROR(::rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_NAMED(name, ...) RCLCPP_FATAL(::rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG(...) RCUTILS_LOG_DEBUG_NAMED("", __VA_ARGS__)
#define RCUTILS_LOG_INFO(...) RCUTILS_LOG_INFO_NAMED("", __VA_ARGS__)
#define RCUTILS_LOG_WARN(...) RCUTILS_LOG_WARN_NAMED("", __VA_ARGS__)
#define RCUTILS_LOG_ERROR(...) RCUTILS_LOG_ERROR_NAMED("", __VA_ARGS__)
#define RCUTILS_LOG_FATAL(...) RCUTILS_LOG_FATAL_NAMED("", __VA_ARGS__)

#endif
