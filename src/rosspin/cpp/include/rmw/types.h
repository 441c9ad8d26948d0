// The quality of service as the middleware's interface has it.
#ifndef ROSSPIN_RMW_TYPES_H
#define ROSSPIN_RMW_TYPES_H

#include <cstddef>
#include <cstdint>

struct rmw_time_t
{
  std::uint64_t sec = 0, nsec = 0;
};
typedef rmw_time_t rmw_time_s;
enum rmw_qos_history_policy_t
{
  RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_HISTORY_KEEP_LAST,
  RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  RMW_QOS_POLICY_HISTORY_UNKNOWN
};
enum rmw_qos_reliability_policy_t
{
  RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT,
  RMW_QOS_POLICY_RELIABILITY_UNKNOWN,
  RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE
};
enum rmw_qos_durability_policy_t
{
  RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  RMW_QOS_POLICY_DURABILITY_VOLATILE,
  RMW_QOS_POLICY_DURABILITY_UNKNOWN,
  RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE
};
enum rmw_qos_liveliness_policy_t
{
  RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT,
  RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC = 3,
  RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
  RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE
};
struct rmw_qos_profile_t
{
  rmw_qos_history_policy_t history;
  std::size_t depth;
  rmw_qos_reliability_policy_t reliability;
  rmw_qos_durability_policy_t durability;
  rmw_time_t deadline{}, lifespan{};
  rmw_qos_liveliness_policy_t liveliness = RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT;
  rmw_time_t liveliness_lease_duration{};
  bool avoid_ros_namespace_conventions = false;
};
#define RMW_DURATION_INFINITE (rmw_time_t{9223372036LL, 854775807LL})
#define RMW_QOS_DEADLINE_DEFAULT (rmw_time_t{0LL, 0LL})
#define RMW_QOS_LIFESPAN_DEFAULT (rmw_time_t{0LL, 0LL})
#define RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT (rmw_time_t{0LL, 0LL})

static const rmw_qos_profile_t rmw_qos_profile_default = {RMW_QOS_POLICY_HISTORY_KEEP_LAST, 10,
    RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
static const rmw_qos_profile_t rmw_qos_profile_sensor_data = {RMW_QOS_POLICY_HISTORY_KEEP_LAST, 5,
    RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_DURABILITY_VOLATILE};
static const rmw_qos_profile_t rmw_qos_profile_parameters = {RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000,
    RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_VOLATILE};
static const rmw_qos_profile_t rmw_qos_profile_services_default = rmw_qos_profile_default;
static const rmw_qos_profile_t rmw_qos_profile_parameter_events = rmw_qos_profile_parameters;
static const rmw_qos_profile_t rcl_qos_profile_rosout_default = {RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1000,
    RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL, {0, 0}, {10, 0}};
static const rmw_qos_profile_t rmw_qos_profile_system_default = {RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, 0,
    RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT};
static const rmw_qos_profile_t rmw_qos_profile_best_available = {RMW_QOS_POLICY_HISTORY_KEEP_LAST, 10,
    RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE, RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE, {9223372036LL, 854775806LL},
    {0, 0}, RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE, {9223372036LL, 854775806LL}};

struct rmw_request_id_t
{
  std::int8_t writer_guid[16]{};
  std::int64_t sequence_number = 0;
};
struct rmw_gid_t
{
  std::uint8_t data[16]{};
};
struct rmw_message_info_t
{
  std::int64_t source_timestamp = 0, received_timestamp = 0;
  std::uint64_t publication_sequence_number = 0, reception_sequence_number = 0;
  rmw_gid_t publisher_gid;
  bool from_intra_process = false;
};

typedef enum rmw_qos_policy_kind_e
{
  RMW_QOS_POLICY_INVALID = 1 << 0,
  RMW_QOS_POLICY_DURABILITY = 1 << 1,
  RMW_QOS_POLICY_DEADLINE = 1 << 2,
  RMW_QOS_POLICY_LIVELINESS = 1 << 3,
  RMW_QOS_POLICY_RELIABILITY = 1 << 4,
  RMW_QOS_POLICY_HISTORY = 1 << 5,
  RMW_QOS_POLICY_LIFESPAN = 1 << 6,
  RMW_QOS_POLICY_DEPTH = 1 << 7,
} rmw_qos_policy_kind_t;

#endif
