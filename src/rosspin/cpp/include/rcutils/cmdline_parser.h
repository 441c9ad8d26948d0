#ifndef ROSSPIN_RCUTILS_CMDLINE_PARSER_H
#define ROSSPIN_RCUTILS_CMDLINE_PARSER_H

#include <cstring>

inline bool rcutils_cli_option_exist(char** begin, char** end, const char* option)
{
  for (char** word = begin; word != end; word++)
    if (std::strcmp(*word, option) == 0)
      return true;
  return false;
}

inline char* rcutils_cli_get_option(char** begin, char** end, const char* option)
{
  for (char** word = begin; word != end; word++)
    if (std::strcmp(*word, option) == 0 && word + 1 != end)
      return word[1];
  return nullptr;
}

#endif
