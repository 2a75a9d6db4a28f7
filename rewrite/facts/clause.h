// The clauses of a pragma: the table in clauses.def.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace symreal::rewrite {

enum class Clause {
#define CLAUSE(name, where, traits, key, what) name,
#include "rewrite/facts/clauses.def"
#undef CLAUSE
};

namespace trait {
enum Of : unsigned { OBJECTS = 1, GIVEN = 2, KEPT = 4, RESULTS = 8, SETTING = 16, SINGLE = 32, BARE = 64, WORDS = 128 };
enum Where : unsigned { BLOCK = 1, FUNCTION = 2 };
} // namespace trait

struct ClauseInfo {
  Clause clause;
  std::string_view name;
  unsigned where, traits;
  std::string_view key;
  bool has(unsigned wanted) const { return (traits & wanted) != 0; }
};

std::span<ClauseInfo const> clause_table();
ClauseInfo const &info(Clause clause);
std::string name_of(Clause clause);
std::optional<Clause> find_clause(std::string_view name);
// The clause with this name or configuration key.
std::optional<Clause> find_configured_clause(std::string_view key);

} // namespace symreal::rewrite
