// Collection of `#pragma symreal` directives while the source is preprocessed.
//
// A pragma in a block also puts `(void)(item);` into the token stream for each of its items, at the item's own place.
// So the compiler itself looks up the names: an undeclared one is its error at that place, and the statement shows in
// the syntax tree the item's type and whether the pragma stands where a statement can.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/pragma/pragma_parser.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <memory>
#include <vector>

namespace symreal::rewrite {

// An item of this source's pragmas, found by the raw location of its statement in the syntax tree.
struct ItemKey {
  Span pragma;
  std::size_t clause;
  std::size_t item;
};

struct PragmaIndex {
  bool ask_compiler = true; // put the items into the token stream
  std::map<unsigned, ItemKey> statements;
  // Names that the items of function pragmas look up, each at its token's place.
  struct Name {
    std::string text;
    Place place;
    ItemKey item;
    bool is_base; // the first name of the item
  };
  std::vector<Name> function_names;
  std::map<Span, clang::SourceLocation> function_pragmas;
  std::map<Span, clang::SourceLocation> statement_pragmas; // decisions(...), loop(...) and exact
  std::vector<ExternalPragma> externals;
};

// Tokens of a directive, each with its place and whether it is a name to look up rather than a keyword or macro.
struct PragmaWords {
  std::vector<PragmaToken> tokens;
  std::vector<Place> places;
  std::vector<bool> names;
};

// Adds the clauses of a parsed directive to its fact, whose key is `span`; for a function pragma also the names to look
// up.
void add_clauses(PragmaFact &fact, Pragma const &pragma, PragmaWords const &words, Span const &span,
                 std::vector<PragmaIndex::Name> &names);

std::unique_ptr<clang::PragmaHandler> make_pragma_handler(SourceMap const &map, Facts &facts, PragmaIndex &index);

} // namespace symreal::rewrite
