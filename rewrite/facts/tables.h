// The words of facts, each a row of a table: the clauses of a pragma (clauses.def), the uses for which expressions of
// the sources are wrapped (uses.def), and the reasons against a select (reasons.def).
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::rewrite {

namespace trait {
enum Of : unsigned { OBJECTS = 1, GIVEN = 2, KEPT = 4, RESULTS = 8, SETTING = 16, SINGLE = 32, BARE = 64, WORDS = 128 };
enum Where : unsigned { BLOCK = 1, FUNCTION = 2 };
enum OfUse : unsigned { NEEDED = 1, BY_TYPES = 2, BRACE = 4, OUTERMOST = 8 };
} // namespace trait

enum class Clause {
#define CLAUSE(name, where, traits, key, what) name,
#include "rewrite/facts/clauses.def"
#undef CLAUSE
};

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

enum class Use {
#define USE(name, payload, traits, text, what) name,
#include "rewrite/facts/uses.def"
#undef USE
};

enum class Payload { none, type, arguments, place, bits, function, text, parameters, name, words, layout };

struct UseInfo {
  std::string_view name;
  Payload payload;
  unsigned traits;
  std::string_view text;
  bool has(unsigned wanted) const { return (traits & wanted) != 0; }
};

UseInfo const &info(Use use);
std::optional<Use> find_use(std::string_view name);

enum class ReasonId {
#define REASON(name, words) name,
#include "rewrite/facts/reasons.def"
#undef REASON
};

struct Reason {
  ReasonId id = {};
  std::string subject = {};         // its operand, such as a name
  std::vector<Reason> because = {}; // at most one: the reason behind it, and
  Place place = {};                 // place of that
  bool operator==(Reason const &other) const { return id == other.id && subject == other.subject; }
};

// "a call of 'f', which has 'goto' (m.c:3:5)"
std::string words(Reason const &reason);
// Text shared by all reasons of the kind: "a call of '...', which has 'goto'", however many calls deep it is.
std::string kind(Reason const &reason);

} // namespace symreal::rewrite
