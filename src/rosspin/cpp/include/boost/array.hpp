#ifndef ROSSPIN_BOOST_ARRAY_HPP
#define ROSSPIN_BOOST_ARRAY_HPP

#include <array>

namespace boost
{
using std::array;
}

#endif
