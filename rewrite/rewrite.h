// Rewriter of sources to symbolic programs: `double` becomes REAL, and `#pragma symreal` lines annotation macros.
//
//   sources ──collect──▶ facts ──decide──▶ rewordings, kernels, diagnostics ──compose──▶ files
//             Clang               plain                                       plain
//
// This library is the only part that knows Clang, and nothing of Clang shows in this header. It reads files and writes
// none: the caller puts the texts into an overlay, a diff or a mirror.
#pragma once

#include "rewrite/facts/result.h"

namespace symreal::rewrite {

// Throws DiagnosticError only for a source that cannot be read; all else is found in Result::diagnostics.
Result run(Request const &request);

// Files of the original with annotations only, which verification compiles. `kernels` and the like are left out.
Result annotated_original(Result const &result);

} // namespace symreal::rewrite
