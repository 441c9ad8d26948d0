// Quality of service of rclcpp.
#ifndef ROSSPIN_RCLCPP_QOS_HPP
#define ROSSPIN_RCLCPP_QOS_HPP

#include "rclcpp/time.hpp"

namespace rclcpp
{
enum class HistoryPolicy
{
  KeepLast = RMW_QOS_POLICY_HISTORY_KEEP_LAST,
  KeepAll = RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  SystemDefault = RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT,
  Unknown = RMW_QOS_POLICY_HISTORY_UNKNOWN,
};
enum class ReliabilityPolicy
{
  BestEffort = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT,
  Reliable = RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  SystemDefault = RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
};
enum class DurabilityPolicy
{
  Volatile = RMW_QOS_POLICY_DURABILITY_VOLATILE,
  TransientLocal = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  SystemDefault = RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_DURABILITY_UNKNOWN,
};
enum class LivelinessPolicy
{
  Automatic = RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  ManualByTopic = RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC,
  SystemDefault = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
  BestAvailable = RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE,
  Unknown = RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
};

struct QoSInitialization
{
  rmw_qos_history_policy_t history_policy;
  std::size_t depth;
  QoSInitialization(rmw_qos_history_policy_t history, std::size_t depth, bool = true)
    : history_policy(history), depth(depth)
  {
  }
  static QoSInitialization from_rmw(const rmw_qos_profile_t& profile)
  {
    return QoSInitialization(profile.history, profile.depth);
  }
};
struct KeepAll : QoSInitialization
{
  KeepAll() : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_ALL, 0) {}
};
struct KeepLast : QoSInitialization
{
  explicit KeepLast(std::size_t depth, bool = true) : QoSInitialization(RMW_QOS_POLICY_HISTORY_KEEP_LAST, depth) {}
};

class QoS
{
public:
  explicit QoS(const QoSInitialization& start, const rmw_qos_profile_t& profile = rmw_qos_profile_default)
    : profile_(profile)
  {
    profile_.history = start.history_policy;
    profile_.depth = start.depth;
  }
  QoS(std::size_t history_depth) : QoS(KeepLast(history_depth)) {}

  rmw_qos_profile_t& get_rmw_qos_profile() { return profile_; }
  const rmw_qos_profile_t& get_rmw_qos_profile() const { return profile_; }

#define ROSSPIN_POLICY(name, Policy, type)                                                                             \
  QoS& name(type policy)                                                                                               \
  {                                                                                                                    \
    profile_.name = policy;                                                                                            \
    return *this;                                                                                                      \
  }                                                                                                                    \
  QoS& name(Policy policy) { return name(static_cast<type>(policy)); }                                                 \
  Policy name() const { return static_cast<Policy>(profile_.name); }
  ROSSPIN_POLICY(history, HistoryPolicy, rmw_qos_history_policy_t)
  ROSSPIN_POLICY(reliability, ReliabilityPolicy, rmw_qos_reliability_policy_t)
  ROSSPIN_POLICY(durability, DurabilityPolicy, rmw_qos_durability_policy_t)
  ROSSPIN_POLICY(liveliness, LivelinessPolicy, rmw_qos_liveliness_policy_t)
#undef ROSSPIN_POLICY
#define ROSSPIN_LENGTH(name)                                                                                           \
  QoS& name(rmw_time_t length)                                                                                         \
  {                                                                                                                    \
    profile_.name = length;                                                                                            \
    return *this;                                                                                                      \
  }                                                                                                                    \
  QoS& name(const Duration& length) { return name(length.to_rmw_time()); }                                             \
  Duration name() const { return Duration::from_rmw_time(profile_.name); }
  ROSSPIN_LENGTH(deadline)
  ROSSPIN_LENGTH(lifespan)
  ROSSPIN_LENGTH(liveliness_lease_duration)
#undef ROSSPIN_LENGTH
  QoS& keep_last(std::size_t depth)
  {
    profile_.depth = depth;
    return history(HistoryPolicy::KeepLast);
  }
  QoS& keep_all()
  {
    profile_.depth = 0;
    return history(HistoryPolicy::KeepAll);
  }
  QoS& reliable() { return reliability(ReliabilityPolicy::Reliable); }
  QoS& best_effort() { return reliability(ReliabilityPolicy::BestEffort); }
  QoS& reliability_best_available() { return reliability(ReliabilityPolicy::BestAvailable); }
  QoS& durability_volatile() { return durability(DurabilityPolicy::Volatile); }
  QoS& transient_local() { return durability(DurabilityPolicy::TransientLocal); }
  QoS& durability_best_available() { return durability(DurabilityPolicy::BestAvailable); }
  QoS& avoid_ros_namespace_conventions(bool avoid)
  {
    profile_.avoid_ros_namespace_conventions = avoid;
    return *this;
  }
  bool avoid_ros_namespace_conventions() const { return profile_.avoid_ros_namespace_conventions; }
  std::size_t depth() const { return profile_.depth; }

private:
  rmw_qos_profile_t profile_;
};

bool operator==(const QoS& one, const QoS& other);
std::string qos_policy_name_from_kind(rmw_qos_policy_kind_t kind);
inline bool operator!=(const QoS& one, const QoS& other) { return !(one == other); }

#define ROSSPIN_QOS(Name, profile, start)                                                                              \
  class Name : public QoS                                                                                              \
  {                                                                                                                    \
  public:                                                                                                              \
    explicit Name(const QoSInitialization& how = start) : QoS(how, profile) {}                                         \
  }
ROSSPIN_QOS(SensorDataQoS, rmw_qos_profile_sensor_data, QoSInitialization::from_rmw(rmw_qos_profile_sensor_data));
ROSSPIN_QOS(ClockQoS, rmw_qos_profile_sensor_data, KeepLast(1));
ROSSPIN_QOS(ParametersQoS, rmw_qos_profile_parameters, QoSInitialization::from_rmw(rmw_qos_profile_parameters));
ROSSPIN_QOS(ServicesQoS, rmw_qos_profile_services_default,
    QoSInitialization::from_rmw(rmw_qos_profile_services_default));
ROSSPIN_QOS(ParameterEventsQoS, rmw_qos_profile_parameter_events,
    QoSInitialization::from_rmw(rmw_qos_profile_parameter_events));
ROSSPIN_QOS(RosoutQoS, rcl_qos_profile_rosout_default, QoSInitialization::from_rmw(rcl_qos_profile_rosout_default));
ROSSPIN_QOS(SystemDefaultsQoS, rmw_qos_profile_system_default,
    QoSInitialization::from_rmw(rmw_qos_profile_system_default));
ROSSPIN_QOS(BestAvailableQoS, rmw_qos_profile_best_available,
    QoSInitialization::from_rmw(rmw_qos_profile_best_available));
#undef ROSSPIN_QOS
}  // namespace rclcpp

#endif
