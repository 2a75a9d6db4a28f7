// Collector of the language's answers about types: selected overloads and specialisations, and the values of traits,
// concepts and sizeof. A class in place of a number may change them without a trace in the text. So they are collected
// twice, from the original and from the rewritten source, and compared.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// `asks`: whether one of the questions is about the type of a number.
struct CollectedChoices {
  Choices choices;
  bool asks = false;
};

CollectedChoices collect_choices(clang::ASTContext &context, SourceMap const &map);

} // namespace symreal::rewrite
