// printf for logs. A node is written for a computer on which a long has 64 bits; here it has 32. So each value is written
// by its own type, whatever the format says of its size.
#ifndef ROSSPIN_FORMAT_H
#define ROSSPIN_FORMAT_H

#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>

namespace rosspin
{
struct Argument
{
  enum Kind { whole, real, text, pointer } kind;
  std::int64_t integer = 0;
  double number = 0;
  const void* address = nullptr;

  template<class T>
  Argument(T value)
  {
    if constexpr (std::is_enum_v<T>)
    {
      *this = Argument(static_cast<std::underlying_type_t<T>>(value));
    }
    else if constexpr (std::is_integral_v<T>)
    {
      kind = whole;
      integer = static_cast<std::int64_t>(value);
    }
    else if constexpr (std::is_floating_point_v<T>)
    {
      kind = real;
      number = static_cast<double>(value);
    }
    else if constexpr (std::is_convertible_v<T, const char*>)
    {
      kind = text;
      address = static_cast<const char*>(value);
    }
    else
    {
      static_assert(std::is_convertible_v<T, const void*> || std::is_null_pointer_v<T>,
          "only numbers, texts of C and pointers can be formatted; of a std::string, give its c_str()");
      kind = pointer;
      address = static_cast<const void*>(value);
    }
  }
};

std::string formatted(const char* format, std::initializer_list<Argument> arguments);
}  // namespace rosspin

#endif
