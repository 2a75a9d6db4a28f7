// From facts to what is done about them: the text of each file, the kernels, the diagnostics. Knows no Clang.
#pragma once

#include "rewrite/edit/compose.h"
#include "rewrite/facts/facts.h"
#include "rewrite/facts/spans.h"

namespace symreal::rewrite {

Result decide(Facts facts, Request const &request);

// What makes selects of decisions, where nothing refuses it (decide_selects.cpp).
void add_selects(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings, Result &result);

// What becomes of every type that the files spell. A type that none of the facts accounts for is an internal error
// (ledger.cpp).
class Ledger {
public:
  explicit Ledger(Facts const &facts);

  bool is_kept(Span const &span) const { return meets(kept_, span); }
  // Kept, or part of a `long double`.
  bool stays_in_text(Span const &span) const { return meets(kept_, span) || long_.count(span) != 0; }
  // The entries of a file, which must agree with what was done to it.
  std::vector<Spelling> entries(std::string const &path, std::vector<Edit> const &edits) const;

private:
  Spelling entry(FileFact const &file, SpelledType const &type) const;
  std::string condition(SpelledType const &type) const;
  TypeToken const *known(Span const &span) const;

  Facts const &facts_;
  std::set<Span> pragmas_, kept_, long_;
};

// The kernels that the pragmas ask for, and what is wrong with them (kernels.cpp).
void collect_kernels(Facts const &facts, Result &result);

} // namespace symreal::rewrite
