// The edits in the form that Clang's tools exchange.
#pragma once

#include "rewrite/facts/result.h"

namespace symreal::rewrite {

// The YAML that clang-apply-replacements reads.
std::string fixes_yaml(std::vector<File> const &files);

} // namespace symreal::rewrite
