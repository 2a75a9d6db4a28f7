// Mangled names of types, in which classes of the runtime stand for numbers.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace symreal::trace {

// typeid's name of the same type in the original: d for a RealNumber, St6vectorIdSaIdEE for a vector of them. Nullopt
// if it has a part that the reader does not support, or that the rewriter may have changed: an expression, the type of
// a lambda.
std::optional<std::string> original_type_name(std::string_view mangled);

// Names that a thread of the program has asked for.
struct TypeNames {
  std::set<std::string> texts;    // that the program holds on to
  std::set<std::string> reported; // places
};

} // namespace symreal::trace
