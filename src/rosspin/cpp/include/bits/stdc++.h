// g++'s header of all headers.
#include "rosspin/prelude.hpp"

#include <bitset>
#include <cassert>
#include <cctype>
#include <cfloat>
#include <climits>
#include <complex>
#include <forward_list>
#include <iterator>
#include <list>
#include <optional>
#include <regex>
#include <stack>
#include <tuple>
#include <unordered_set>
#include <variant>
