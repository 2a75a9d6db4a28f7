// Decision stage: turns facts into the text of each file, the kernels and the diagnostics. Independent of Clang.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/text/compose.h"

namespace symreal::rewrite {

Result decide(Facts facts, Request const &request);

// Whether the variadic function reads numbers, or passes its list to one that does; once decide() has followed the
// lists.
bool reads_numbers(Facts const &facts, std::string const &function);

// Ledger of all types that the files spell, with the fate of each. A type that no fact accounts for is an internal
// error (ledger.cpp).
class Ledger {
public:
  explicit Ledger(Facts const &facts);

  bool is_pragma(Span const &span) const { return meets(pragmas_, span); }
  // Fate of a token that reaches the parser, outside of pragmas, and its reason.
  Spelling judged(Span const &span, TypeToken const &token) const;
  // Entries of a file, which must agree with its edits.
  std::vector<Spelling> entries(std::string const &path, std::vector<Edit> const &edits) const;

private:
  Spelling entry(FileFact const &file, SpelledType const &type) const;
  std::string condition(SpelledType const &type) const;

  Facts const &facts_;
  std::set<Span> pragmas_, kept_, long_;
};

// By the real path of a file.
using Rewordings = std::map<std::string, std::vector<Rewording>>;

// All rewordings but those of pragmas (rewordings.cpp).
Rewordings reword(Facts &facts, Ledger const &ledger, Result &result);
void add_pragmas(Facts const &facts, Rewordings &rewordings);

// Collects the kernels that the pragmas ask for, and their errors (kernels.cpp).
void collect_kernels(Facts const &facts, Result &result);

// Edits that only add annotations to the file; empty without annotations (annotated_original.cpp).
std::vector<Edit> original_edits(Facts const &facts, std::string const &path);

// Result for the original with its annotations: texts and kernels.
Result annotated(Facts const &facts, Result result);

} // namespace symreal::rewrite
