// What nodes use of rcutils's logging by itself.
#ifndef ROSSPIN_RCUTILS_LOGGING_H
#define ROSSPIN_RCUTILS_LOGGING_H

typedef int rcutils_ret_t;
typedef int rcl_ret_t;
#define RCUTILS_RET_OK 0
#define RCUTILS_RET_ERROR 2
#define RCUTILS_RET_INVALID_ARGUMENT 11
#define RCL_RET_OK 0
#define RCL_RET_ERROR 1

enum RCUTILS_LOG_SEVERITY
{
  RCUTILS_LOG_SEVERITY_UNSET = 0,
  RCUTILS_LOG_SEVERITY_DEBUG = 10,
  RCUTILS_LOG_SEVERITY_INFO = 20,
  RCUTILS_LOG_SEVERITY_WARN = 30,
  RCUTILS_LOG_SEVERITY_ERROR = 40,
  RCUTILS_LOG_SEVERITY_FATAL = 50,
};

rcutils_ret_t rcutils_logging_set_logger_level(const char* name, int level);
int rcutils_logging_get_logger_level(const char* name);
int rcutils_logging_get_logger_effective_level(const char* name);
void rcutils_logging_set_default_logger_level(int level);

// What has gone wrong last is never kept.
struct rcutils_error_string_t
{
  char str[1024];
};
inline rcutils_error_string_t rcutils_get_error_string() { return {"error not set"}; }
inline void rcutils_reset_error() {}

#endif
