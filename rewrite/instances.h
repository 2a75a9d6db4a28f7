// Walks the instantiations of templates and of generic lambdas within the roots.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/integer_state.h"
#include "rewrite/reals.h"
#include "rewrite/source_map.h"
#include "rewrite/surroundings.h"

namespace symreal::rewrite {

void record_instances(clang::ASTContext &context, SourceMap const &map, Reals const &reals,
                      IntegerState const &integers, Surroundings const &surroundings, Facts &facts);

} // namespace symreal::rewrite
