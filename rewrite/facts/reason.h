// What is in the way of a select: the table in reasons.def.
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
  std::string subject = {};         // what it is about
  std::vector<Reason> because = {}; // at most one: the reason behind it, and
  Place place = {};                 // where that stands
  bool operator==(Reason const &other) const { return id == other.id && subject == other.subject; }
};

// "a call of 'f', which has 'goto' (m.c:3:5)"
std::string words(Reason const &reason);
// The same for all reasons of its kind: "a call of '...', which has 'goto'", however many calls deep it is.
std::string kind(Reason const &reason);

} // namespace symreal::rewrite
