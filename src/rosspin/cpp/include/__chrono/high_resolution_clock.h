// With g++, this is the system's clock, and with clang, the steady one.
#ifndef ROSSPIN_HIGH_RESOLUTION_CLOCK_H
#define ROSSPIN_HIGH_RESOLUTION_CLOCK_H

#include <__chrono/system_clock.h>

_LIBCPP_BEGIN_NAMESPACE_STD
namespace chrono
{
using high_resolution_clock = system_clock;
}
_LIBCPP_END_NAMESPACE_STD

#endif
