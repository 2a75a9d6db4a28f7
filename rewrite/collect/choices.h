// What the language finds out about types: which overload or specialisation it chooses, what a trait, a concept or a
// sizeof says. Where a class stands for a number the answers may be others, and nothing in the text shows it. So they
// are collected twice, from the original and from the rewritten source, and compared.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

// At one place of a function.
struct Choice {
  Place place;
  std::string what;
  std::set<std::string> results; // of all instantiations there
};
using Choices = std::map<std::string, Choice>;

// Of the original: nothing where it does not ask about the type of a number. `of_rewritten`: all that there is.
void collect_choices(clang::ASTContext &context, SourceMap const &map, bool of_rewritten, Choices &choices);

} // namespace symreal::rewrite
