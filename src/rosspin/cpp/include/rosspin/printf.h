// printf and its like for nodes: as in a log, each value is written by its own type, whatever the format says of its size.
#ifndef ROSSPIN_PRINTF_H
#define ROSSPIN_PRINTF_H

#include <cstdio>
#include <cstring>

#include "rosspin/format.h"

template<class... Values>
__attribute__((format(printf, 2, 3))) int fprintf(std::FILE* stream, const char* format, Values... values)
{
  std::string text = rosspin::formatted(format, {rosspin::Argument(values)...});
  return std::fwrite(text.data(), 1, text.size(), stream) == text.size() ? static_cast<int>(text.size()) : -1;
}

template<class... Values>
__attribute__((format(printf, 1, 2))) int printf(const char* format, Values... values)
{
  return fprintf(stdout, format, values...);
}

template<class... Values>
__attribute__((format(printf, 3, 4))) int snprintf(
    char* to, std::size_t size, const char* format, Values... values)
{
  std::string text = rosspin::formatted(format, {rosspin::Argument(values)...});
  if (size)
    to[text.copy(to, size - 1)] = '\0';
  return static_cast<int>(text.size());
}

template<class... Values>
__attribute__((format(printf, 2, 3))) int sprintf(char* to, const char* format, Values... values)
{
  std::string text = rosspin::formatted(format, {rosspin::Argument(values)...});
  std::memcpy(to, text.c_str(), text.size() + 1);
  return static_cast<int>(text.size());
}

namespace std
{
using ::fprintf;
using ::printf;
using ::snprintf;
using ::sprintf;
}  // namespace std

#endif
