// Head lines of functions, and of the parts that a long function is cut into.
#pragma once

#include "engine/emit/language/language.h"

#include <string>
#include <string_view>

namespace symreal {

struct FunctionHead {
  std::string name;
  std::string parameters = {};
  std::string target = {}; // the last parameter
  bool may_fail = false, is_pure = false, is_apart = false, is_side_by_side = false;
};

// `pattern`: the language's pattern for a function, or for a part.
std::string print_head(Language const &language, std::string_view pattern, FunctionHead const &head);

} // namespace symreal
