// From facts to what is done about them: the text of each file, the kernels, the diagnostics. Knows no Clang.
#pragma once

#include "rewrite/compose.h"
#include "rewrite/facts.h"

namespace symreal::rewrite {

Result decide(Facts facts, Request const &request);

// What makes selects of decisions, where nothing refuses it (decide_selects.cpp).
void add_selects(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings, Result &result);

// Do any of the sorted, disjoint spans overlap this one?
bool meets(std::set<Span> const &spans, Span const &span);

// What stands there.
std::string text_of(Span const &span, Facts const &facts);

Place place_in(FileFact const &file, std::size_t offset);

// Would a macro around the expression stand in an argument that becomes text? An expression may also hold the whole
// macro call.
bool is_quoted(Facts const &facts, Span const &expression);

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
