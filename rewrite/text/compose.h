// Composition of rewordings into edits: replacements and nested wraps on the same file become a sorted list of disjoint
// edits, each on at least one original character.
#pragma once

#include "rewrite/facts/result.h"

#include <string>
#include <vector>

namespace symreal::rewrite {

// Characters [begin, end) become before + (replacement, or the original) + after.
struct Rewording {
  std::size_t begin;
  std::size_t end;
  std::string before;
  std::string after;
  bool replaces = false; // `before` is all there will be
  int depth = 0;         // among several on the same characters, the least depth is outermost
  auto operator<=>(Rewording const &) const = default;
};

// The rewordings may nest and touch in any way except overlap partly, and nothing may lie within a replaced part.
std::vector<Edit> compose(std::string const &original, std::vector<Rewording> rewordings);

std::string apply_edits(std::string const &original, std::vector<Edit> const &edits);

} // namespace symreal::rewrite
