#include "engine/support/mutation/is_dropped.h"

#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <cstdlib>

namespace symreal {

// Rules without a diagnostic and without another name in the rewriter.
static constexpr std::string_view rules[] = {
    "baked",            // a wrapper compares what the recording has baked in
    "beyond_guards",    // a static integer that another path may read is state
    "check_bits",       // a number of which a part was overwritten is told from others
    "chosen",           // constants that the caller hands over are looked at like other memory
    "constant_changed", // a constant that is read must still be what it was when the kernel ends
    "extents",          // and the extents of containers
    "generic",          // the controlling expression of _Generic has the type that it has in C
    "handed_over",      // the object that a function returns may change
    "list_text",        // text that is made of a list of arguments comes from its numbers
    "memory",           // what code that was not rewritten leaves in memory
    "overlaps",         // and how its arguments lie
    "torn",             // numbers of which a part was overwritten
// functions whose results come from outside the program
#define OUTSIDE(result, symbol, ...) #symbol,
#include "engine/support/outside.def"
#undef OUTSIDE
};

bool asks_by_name(std::string_view rule) { return std::ranges::find(rules, rule) != std::end(rules); }

bool is_dropped(std::string_view rule) {
  char const *const name = std::getenv("SYMREAL_DROP_RULE");
  internal_check(asks_by_name(rule) || find_diagnostic(rule));
  return name && rule == name;
}

} // namespace symreal
