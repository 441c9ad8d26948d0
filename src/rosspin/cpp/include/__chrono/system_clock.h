// The system's clock as in g++'s library, where it counts nanoseconds; in clang's it counts microseconds.
#ifndef ROSSPIN_SYSTEM_CLOCK_H
#define ROSSPIN_SYSTEM_CLOCK_H

#include <__chrono/duration.h>
#include <__chrono/time_point.h>
#include <ctime>

// The library has functions of these names, too.
#define ROSSPIN_OWN __attribute__((abi_tag("rosspin")))

_LIBCPP_BEGIN_NAMESPACE_STD
namespace chrono
{
class system_clock
{
public:
  using duration = nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = chrono::time_point<system_clock>;
  static constexpr bool is_steady = false;

  ROSSPIN_OWN static time_point now() noexcept
  {
    timespec time;
    clock_gettime(CLOCK_REALTIME, &time);
    return time_point(seconds(time.tv_sec) + nanoseconds(time.tv_nsec));
  }
  ROSSPIN_OWN static time_t to_time_t(const time_point& time) noexcept
  {
    return duration_cast<seconds>(time.time_since_epoch()).count();
  }
  ROSSPIN_OWN static time_point from_time_t(time_t time) noexcept { return time_point(seconds(time)); }
};
}  // namespace chrono
_LIBCPP_END_NAMESPACE_STD

#undef ROSSPIN_OWN

#endif
