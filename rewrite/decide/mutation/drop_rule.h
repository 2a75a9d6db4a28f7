// For the mutation test (tests/mutation): a build with SYMREAL_MUTATION leaves out the rule of SYMREAL_DROP_RULE.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

void drop_rule(Facts &facts);

} // namespace symreal::rewrite
