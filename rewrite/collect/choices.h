// What the language finds out about types: which overload or specialisation it chooses, what a trait, a concept or a
// sizeof says. Where a class stands for a number the answers may be others, and nothing in the text shows it. So they
// are collected twice, from the original and from the rewritten source, and compared.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// `asks`: one of them is about the type of a number.
struct CollectedChoices {
  Choices choices;
  bool asks = false;
};

CollectedChoices collect_choices(clang::ASTContext &context, SourceMap const &map);

} // namespace symreal::rewrite
