// Collects `#pragma symreal` directives while the source is preprocessed.
//
// A pragma in a block also puts `(void)(item);` into the token stream for each of its items, at the item's own place.
// So the compiler itself looks the names up where the pragma stands: an undeclared one is its error at that place, and
// the statement shows in the syntax tree what the item is and whether the pragma stands where a statement can.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/pragma/pragma_parser.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <memory>
#include <vector>

namespace symreal::rewrite {

// The items of this source's pragmas by the raw location that their statement has in the syntax tree.
struct ItemKey {
  Span pragma;
  std::size_t clause;
  std::size_t item;
};

// `external(f)` and what stands beside it (externals.h).
struct ExternalPragma {
  struct Item {
    std::string name;
    std::vector<std::string> lengths; // of its sections
    Place place;
  };
  std::string function;
  Place name_place;
  bool pure = false;
  std::vector<Item> inputs, outputs;
  struct Function {
    std::string name;
    Place place;
  };
  std::vector<Function> derivatives;          // its first, the first of that, ...
  std::optional<std::size_t> configured = {}; // it stands in no file: which of the request's externals it is
};

struct PragmaIndex {
  bool ask_compiler = true; // put the items into the token stream
  std::map<unsigned, ItemKey> statements;
  // Of a function pragma: the names that its items look up, each at its token's place.
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

// The tokens of a directive, each with its place and whether it is a name that is looked up, no keyword or macro.
struct PragmaWords {
  std::vector<PragmaToken> tokens;
  std::vector<Place> places;
  std::vector<bool> names;
};

// Adds the clauses of a parsed directive to its fact, which is known by `span`; of a function pragma also the names
// that must be looked up.
void add_clauses(PragmaFact &fact, Pragma const &pragma, PragmaWords const &words, Span const &span,
                 std::vector<PragmaIndex::Name> &names);

std::unique_ptr<clang::PragmaHandler> make_pragma_handler(SourceMap const &map, Facts &facts, PragmaIndex &index);

} // namespace symreal::rewrite
