// Decision stage: turns facts into the text of each file, the kernels and the diagnostics. Independent of Clang.
#pragma once

#include "rewrite/edit/compose.h"
#include "rewrite/facts/facts.h"
#include "rewrite/facts/spans.h"

namespace symreal::rewrite {

Result decide(Facts facts, Request const &request);

// Adds the rewordings that turn decisions into selects, where no refusal stands against it (decide_selects.cpp).
void add_selects(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings, Result &result);

// Ledger of all types that the files spell, with the fate of each. A type that no fact accounts for is an internal
// error (ledger.cpp).
class Ledger {
public:
  explicit Ledger(Facts const &facts);

  bool is_kept(Span const &span) const { return meets(kept_, span); }
  // Kept, or part of a `long double`.
  bool stays_in_text(Span const &span) const { return meets(kept_, span) || long_.count(span) != 0; }
  // Entries of a file, which must agree with its edits.
  std::vector<Spelling> entries(std::string const &path, std::vector<Edit> const &edits) const;

private:
  Spelling entry(FileFact const &file, SpelledType const &type) const;
  std::string condition(SpelledType const &type) const;
  TypeToken const *known(Span const &span) const;

  Facts const &facts_;
  std::set<Span> pragmas_, kept_, long_;
};

// Collects the kernels that the pragmas ask for, and their errors (kernels.cpp).
void collect_kernels(Facts const &facts, Result &result);

} // namespace symreal::rewrite
