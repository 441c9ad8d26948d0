// Boost's shared pointers are the standard library's.
#ifndef ROSSPIN_BOOST_SHARED_PTR_HPP
#define ROSSPIN_BOOST_SHARED_PTR_HPP

#include <memory>

namespace boost
{
using std::const_pointer_cast;
using std::dynamic_pointer_cast;
using std::enable_shared_from_this;
using std::make_shared;
using std::shared_ptr;
using std::static_pointer_cast;
using std::weak_ptr;
template<class T>
using scoped_ptr = std::unique_ptr<T>;
}  // namespace boost

#endif
