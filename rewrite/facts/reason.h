// Reasons against a select: the table in reasons.def.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

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
