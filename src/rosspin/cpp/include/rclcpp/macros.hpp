// Macros that rclcpp uses, and nodes, too.
#ifndef ROSSPIN_RCLCPP_MACROS_HPP
#define ROSSPIN_RCLCPP_MACROS_HPP

#include <memory>
#include <utility>

#define RCLCPP_DISABLE_COPY(...)                                                                                       \
  __VA_ARGS__(const __VA_ARGS__&) = delete;                                                                            \
  __VA_ARGS__& operator=(const __VA_ARGS__&) = delete;
#define RCLCPP_SHARED_PTR_ALIASES(...)                                                                                 \
  using SharedPtr = std::shared_ptr<__VA_ARGS__>;                                                                      \
  using ConstSharedPtr = std::shared_ptr<const __VA_ARGS__>;                                                           \
  using WeakPtr = std::weak_ptr<__VA_ARGS__>;                                                                          \
  using ConstWeakPtr = std::weak_ptr<const __VA_ARGS__>;
#define RCLCPP_MAKE_SHARED(...)                                                                                        \
  template<typename... Args>                                                                                           \
  static std::shared_ptr<__VA_ARGS__> make_shared(Args&&... args)                                                      \
  {                                                                                                                    \
    return std::make_shared<__VA_ARGS__>(std::forward<Args>(args)...);                                                 \
  }
#define RCLCPP_UNIQUE_PTR_DEFINITIONS(...)                                                                             \
  using UniquePtr = std::unique_ptr<__VA_ARGS__>;                                                                      \
  template<typename... Args>                                                                                           \
  static UniquePtr make_unique(Args&&... args)                                                                         \
  {                                                                                                                    \
    return UniquePtr(new __VA_ARGS__(std::forward<Args>(args)...));                                                    \
  }
#define RCLCPP_SHARED_PTR_DEFINITIONS(...) RCLCPP_SHARED_PTR_ALIASES(__VA_ARGS__) RCLCPP_MAKE_SHARED(__VA_ARGS__)
#define RCLCPP_SMART_PTR_DEFINITIONS(...)                                                                              \
  RCLCPP_SHARED_PTR_DEFINITIONS(__VA_ARGS__) RCLCPP_UNIQUE_PTR_DEFINITIONS(__VA_ARGS__)
#define RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(...) RCLCPP_SMART_PTR_DEFINITIONS(__VA_ARGS__)
#define RCLCPP_SMART_PTR_ALIASES_ONLY(...)                                                                             \
  RCLCPP_SHARED_PTR_ALIASES(__VA_ARGS__) using UniquePtr = std::unique_ptr<__VA_ARGS__>;
#define RCLCPP_STRING_JOIN(one, other) RCLCPP_DO_STRING_JOIN(one, other)
#define RCLCPP_DO_STRING_JOIN(one, other) one##other

#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_LOCAL
#define RCLCPP_PUBLIC
#define RCLCPP_PUBLIC_TYPE
#define RCUTILS_WARN_UNUSED
#define RCUTILS_UNUSED(x) (void)(x)

// What this lacks: named where a node says it, or else when the node gets there.
#define ROSSPIN_NOT_SIMULATED(name)                                                                                    \
  __attribute__((unavailable(name " is not simulated; run this node on a real ROS")))

#endif
