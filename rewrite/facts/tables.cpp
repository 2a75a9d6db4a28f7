#include "rewrite/facts/tables.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace symreal::rewrite {
namespace {

using namespace trait;

constexpr std::array clauses = {
#define CLAUSE(name, where, traits, key, what) ClauseInfo{Clause::name, #name, where, traits, key},
#include "rewrite/facts/clauses.def"
#undef CLAUSE
};

constexpr std::array uses = {
#define USE(name, payload, traits, text, what) UseInfo{#name, Payload::payload, traits, text},
#include "rewrite/facts/uses.def"
#undef USE
};

// Constraints on the order of the rows, which determines how uses nest.
constexpr bool stands_before(Use outer, Use inner) { return outer < inner; }
static_assert(stands_before(Use::as_width, Use::width));
static_assert(stands_before(Use::compound, Use::compound_list));
static_assert(stands_before(Use::range_begin, Use::range_end));
static_assert(stands_before(Use::fill_begin, Use::fill_end));
static_assert(stands_before(Use::cast, Use::conversion));
static_assert(std::is_partitioned(uses.begin(), uses.end(),
                                  [](UseInfo const &row) { return (row.traits & OUTERMOST) == 0; }));
static_assert(std::all_of(uses.begin(), uses.end(),
                          [](UseInfo const &row) { return row.text.find('$') != std::string_view::npos; }));

constexpr std::array<std::string_view, static_cast<std::size_t>(ReasonId::call_with) + 1> reasons = {
#define REASON(name, words) words,
#include "rewrite/facts/reasons.def"
#undef REASON
};

// The place of the first row that passes the test, as an enumerator of the table.
template <class Word, class Table, class Test> std::optional<Word> find(Table const &table, Test test) {
  auto const row = std::find_if(table.begin(), table.end(), test);
  return row == table.end() ? std::nullopt : std::optional(static_cast<Word>(row - table.begin()));
}

std::string filled(Reason const &reason, std::string const &subject) {
  std::string text(reasons[static_cast<std::size_t>(reason.id)]);
  if (std::size_t const at = text.find('$'); at != text.npos) text.replace(at, 1, subject);
  return text;
}

} // namespace

std::span<ClauseInfo const> clause_table() { return clauses; }

ClauseInfo const &info(Clause clause) { return clauses[static_cast<std::size_t>(clause)]; }

std::string name_of(Clause clause) { return std::string(info(clause).name); }

std::optional<Clause> find_clause(std::string_view name) {
  return find<Clause>(clauses, [&](ClauseInfo const &row) { return row.name == name; });
}

std::optional<Clause> find_configured_clause(std::string_view key) {
  return find<Clause>(clauses,
                      [&](ClauseInfo const &row) { return !row.key.empty() && (row.name == key || row.key == key); });
}

UseInfo const &info(Use use) { return uses[static_cast<std::size_t>(use)]; }

std::optional<Use> find_use(std::string_view name) {
  return find<Use>(uses, [&](UseInfo const &row) { return row.name == name; });
}

std::string words(Reason const &reason) {
  std::string text = filled(reason, reason.subject);
  for (Reason const &one : reason.because) {
    text += " " + words(one);
    if (!reason.place.file.empty()) text += " (" + to_string(reason.place) + ")";
  }
  return text;
}

std::string kind(Reason const &reason) {
  std::string text = filled(reason, "'...'");
  if (reason.because.empty()) return text;
  Reason const *next = &reason.because.front();
  if (reason.id == ReasonId::call_with)
    while (next->id == ReasonId::call_with) next = &next->because.front();
  return text + " " + kind(*next);
}

} // namespace symreal::rewrite
