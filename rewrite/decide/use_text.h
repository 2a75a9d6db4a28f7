// Text around an expression for its use (facts/uses.def).
#pragma once

#include "rewrite/edit/compose.h"
#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Nesting depths of rewordings of the same characters, the outermost first; uses lie between `select` and
// `within_uses`, in the order of their rows.
namespace depth {
inline constexpr int outermost = -2, select = -1, within_uses = 100, copy = 1000;
}

// `is_shared`: the text is compiled in several ways, so a conversion follows the type that its context expects.
Rewording rewording(Wrap const &wrap, bool is_shared);

} // namespace symreal::rewrite
