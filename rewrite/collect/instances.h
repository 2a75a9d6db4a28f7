// Walks the instantiations of templates and of generic lambdas within the roots.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/model/scalar_state.h"
#include "rewrite/model/surroundings.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

void collect_instances(clang::ASTContext &context, SourceMap const &map, Reals const &reals, ScalarState const &scalars,
                       Surroundings const &surroundings, Facts &facts);

} // namespace symreal::rewrite
