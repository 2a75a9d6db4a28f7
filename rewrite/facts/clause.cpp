#include "rewrite/facts/clause.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace symreal::rewrite {
namespace {

using namespace trait;

constexpr std::array table = {
#define CLAUSE(name, where, traits, key, what) ClauseInfo{Clause::name, #name, where, traits, key},
#include "rewrite/facts/clauses.def"
#undef CLAUSE
};

template <class Test> std::optional<Clause> find(Test test) {
  auto const row = std::find_if(table.begin(), table.end(), test);
  return row == table.end() ? std::nullopt : std::optional(row->clause);
}

} // namespace

std::span<ClauseInfo const> clause_table() { return table; }

ClauseInfo const &info(Clause clause) { return table[static_cast<std::size_t>(clause)]; }

std::string name_of(Clause clause) { return std::string(info(clause).name); }

std::optional<Clause> find_clause(std::string_view name) {
  return find([&](ClauseInfo const &row) { return row.name == name; });
}

std::optional<Clause> find_configured_clause(std::string_view key) {
  return find([&](ClauseInfo const &row) { return !row.key.empty() && (row.name == key || row.key == key); });
}

} // namespace symreal::rewrite
