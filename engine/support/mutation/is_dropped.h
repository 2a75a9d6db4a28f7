// For the mutation test (tests/mutation): a build with SYMREAL_MUTATION leaves out the rule of SYMREAL_DROP_RULE. Rules
// of the rewriter that are macros or diagnostics are dropped by rewrite/decide/mutation; any other rule asks here.
#pragma once

#include <string_view>

namespace symreal {

#ifdef SYMREAL_MUTATION
bool is_dropped(std::string_view rule);
// Whether a rule of this name asks is_dropped.
bool asks_by_name(std::string_view rule);
#else
static constexpr bool is_dropped(std::string_view) { return false; }
#endif

} // namespace symreal
