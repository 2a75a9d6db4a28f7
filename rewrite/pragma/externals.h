// `#pragma symreal external(f)`: functions of libraries that stay as they are, and whose calls are recorded.
//
//   #pragma symreal external(contact_force) pure input(q[0:3], v[0:3]) output(force[0:3])
//
// The items are parameters of the function. Their sizes are needed where the declaration does not tell them: a number,
// or an integer parameter of the function.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// Looks the functions up, after all of the source has been read, and registers them with `reals`;
// refuses two calls with effects in one expression that the language may order either way.
void collect_externals(clang::ASTContext &context, SourceMap const &map, PragmaIndex const &index, Facts &facts,
                       Reals &reals);

} // namespace symreal::rewrite
