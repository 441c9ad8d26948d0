// Boost's bind and function are the standard library's; its placeholders are in the global namespace.
#ifndef ROSSPIN_BOOST_BIND_HPP
#define ROSSPIN_BOOST_BIND_HPP

#include <functional>

namespace boost
{
template<class Function, class... Bound>
auto bind(Function&& function, Bound&&... bound)
{
  return std::bind(std::forward<Function>(function), std::forward<Bound>(bound)...);
}
template<class Signature>
using function = std::function<Signature>;
using std::cref;
using std::mem_fn;
using std::ref;
namespace placeholders = std::placeholders;
}  // namespace boost

using std::placeholders::_1;
using std::placeholders::_2;
using std::placeholders::_3;
using std::placeholders::_4;
using std::placeholders::_5;
using std::placeholders::_6;
using std::placeholders::_7;
using std::placeholders::_8;
using std::placeholders::_9;

#endif
