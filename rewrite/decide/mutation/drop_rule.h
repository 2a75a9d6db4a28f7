// Switch of the mutation test (tests/mutation): SYMREAL_MUTATION builds leave out the rule in SYMREAL_DROP_RULE.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

void drop_rule(Facts &facts);

} // namespace symreal::rewrite
