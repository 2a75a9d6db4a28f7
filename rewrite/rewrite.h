// Source to symbolic program: rewrites `double` to REAL and `#pragma symreal` lines to annotation macros.
//
//   sources ──collect──▶ facts ──decide──▶ rewordings, kernels, diagnostics ──compose──▶ files
//             Clang               plain                                       plain
//
// This library is the only place that knows Clang, and nothing of Clang shows in this header. It reads files and
// writes none: what becomes of the texts (an overlay, a diff, a mirror) is the caller's matter.
#pragma once

#include "rewrite/facts/result.h"

namespace symreal::rewrite {

// Throws DiagnosticError only for a source that cannot be read; all else is found in Result::diagnostics.
Result run(Request const &request);

// The files with annotations, each with these alone: what verification compiles as the original. `kernels` and the like
// are left out.
Result annotated_original(Result const &result);

} // namespace symreal::rewrite
