#ifndef ROSSPIN_BOOST_LEXICAL_CAST_HPP
#define ROSSPIN_BOOST_LEXICAL_CAST_HPP

#include <sstream>
#include <string>
#include <typeinfo>

namespace boost
{
class bad_lexical_cast : public std::bad_cast
{
public:
  const char* what() const noexcept override
  {
    return "bad lexical cast: source type value could not be interpreted as target";
  }
};

template<class Target, class Source>
Target lexical_cast(const Source& source)
{
  std::stringstream stream;
  stream.precision(17);
  Target target;
  if (!(stream << source) || !(stream >> target) || !(stream >> std::ws).eof())
    throw bad_lexical_cast();
  return target;
}
}  // namespace boost

#endif
