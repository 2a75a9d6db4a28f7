// The language's answers about types: selected overloads and specialisations, and the values of traits, concepts and
// sizeof. A class in place of a number may change them without a trace in the text. So they are collected twice, from
// the original and from the rewritten source, as the symbolic program's compiler will see it, and compared.
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

// Reads the sources that ask about types again, and reports each choice that differs in the symbolic program. A source
// that does not compile reports nothing.
void compare_choices(Choices const &original, std::vector<Compilation> const &asking, Scope const &scope,
                     Request const &request, Result &result);

} // namespace symreal::rewrite
