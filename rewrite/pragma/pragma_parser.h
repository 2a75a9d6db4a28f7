// Parser of `#pragma symreal` directives, independent of Clang and of the names' meanings.
//
//   directive := ["function"] clause { clause } | external
//   clause    := name "(" [item { "," item }] ")"
//   item      := expression in which `[low:length]` may stand where an index may; low may be missing and is then 0
//   external  := "external" "(" name ")" { "pure" | "derivative" "(" name { "," name } ")" | clause }
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace symreal::rewrite {

struct PragmaToken {
  std::string text;
  bool is_name = false; // an identifier or keyword
  bool space_before = false;
};

// Tokens [begin, end) of the directive.
struct TokenRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool empty() const { return begin == end; }
};

struct PragmaSection {
  TokenRange brackets; // with the brackets themselves
  TokenRange low;
  TokenRange length;
};

struct PragmaItem {
  TokenRange tokens;
  std::vector<PragmaSection> sections;
};

struct PragmaClause {
  std::size_t name = 0;
  TokenRange arguments; // between the parentheses
  std::vector<PragmaItem> items;
};

struct Pragma {
  bool is_function = false;
  std::vector<PragmaClause> clauses;
};

struct PragmaError {
  std::size_t token; // the number of tokens: the end of the directive
  DiagnosticId id;
  std::string message;
};

std::variant<Pragma, PragmaError> parse_pragma(std::vector<PragmaToken> const &tokens);

// The source text of the tokens, white space normalised.
std::string text_of(std::vector<PragmaToken> const &tokens, TokenRange range);

// The item with `[(low)+symreal_i[k]]` for its k-th section: the expression of one element.
std::string element_text(std::vector<PragmaToken> const &tokens, PragmaItem const &item);

// The item without its sections.
std::string base_text(std::vector<PragmaToken> const &tokens, PragmaItem const &item);

// A pragma `external(f)` with its other clauses.
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
  struct DerivativeName {
    std::string name;
    Place place;
  };
  std::vector<DerivativeName> derivatives;    // the first derivative, the second, ...
  std::optional<std::size_t> configured = {}; // for a pragma from the request: the index of its external
};

// Parses the tokens of a directive that begins with `external`, each at its place.
std::variant<ExternalPragma, PragmaError> parse_external(std::vector<PragmaToken> const &tokens,
                                                         std::vector<Place> const &places);

} // namespace symreal::rewrite
