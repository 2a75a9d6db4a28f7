#include "rewrite/pragma/pragma_handler.h"

#include "rewrite/text/pragma_text.h"

namespace symreal::rewrite {
namespace {

ItemFact item_fact(std::vector<PragmaToken> const &tokens, PragmaItem const &item) {
  ItemFact fact;
  fact.label = text_of(tokens, item.tokens);
  fact.expression = element_text(tokens, item);
  fact.base = base_text(tokens, item);
  for (PragmaSection const &section : item.sections)
    fact.sections.push_back(
        {section.low.empty() ? "0" : text_of(tokens, section.low), text_of(tokens, section.length)});
  fact.is_return = fact.label == "return";
  std::size_t const next = item.tokens.begin + 1;
  bool const name_first = tokens[item.tokens.begin].is_name && !fact.is_return;
  fact.section_on_base = name_first && !item.sections.empty() && item.sections[0].brackets.begin == next;
  fact.base_is_name = name_first && (next == item.tokens.end || fact.section_on_base);
  return fact;
}

// Every name that is looked up by itself: not after `.`, `->` or `::`, and not before `::`.
void collect_names(PragmaWords const &words, PragmaItem const &item, ItemKey const &key,
                   std::vector<PragmaIndex::Name> &names) {
  auto const is = [&](std::size_t i, std::string const &text) {
    return i < words.tokens.size() && words.tokens[i].text == text;
  };
  for (std::size_t i = item.tokens.begin; i < item.tokens.end; ++i) {
    if (!words.names[i]) continue;
    if (i > 0 && (is(i - 1, ".") || is(i - 1, "->") || is(i - 1, "::"))) continue;
    if (is(i + 1, "::")) continue;
    names.push_back({words.tokens[i].text, words.places[i], key, i == item.tokens.begin});
  }
}

} // namespace

void add_clauses(PragmaFact &fact, Pragma const &pragma, PragmaWords const &words, Span const &span,
                 std::vector<PragmaIndex::Name> &names) {
  for (PragmaClause const &clause : pragma.clauses) {
    ClauseFact &clause_fact = fact.clauses.emplace_back();
    clause_fact.clause = *find_clause(words.tokens[clause.name].text); // as the parser has found
    clause_fact.place = words.places[clause.name];
    clause_fact.argument = text_of(words.tokens, clause.arguments);
    for (PragmaItem const &item : clause.items) {
      clause_fact.items.push_back(item_fact(words.tokens, item));
      clause_fact.items.back().place = words.places[item.tokens.begin];
      if (means_file(clause_fact.clause, clause_fact.items.back())) {
        clause_fact.items.back().seen = true;
        continue;
      }
      if (pragma.is_function && !info(clause_fact.clause).has(trait::SINGLE))
        collect_names(words, item, {span, fact.clauses.size() - 1, clause_fact.items.size() - 1}, names);
    }
  }
}

} // namespace symreal::rewrite
