// Parser of `#pragma symreal` directives, independent of Clang and of the names' meanings.
//
//   directive := ["function"] clause { clause }
//   clause    := name "(" [item { "," item }] ")"
//   item      := expression in which `[low:length]` may stand where an index may; low may be missing and is then 0
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <cstddef>
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

} // namespace symreal::rewrite
