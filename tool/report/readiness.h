// Report of a scan: share of the sources that converts, obstacles, and dependences on values.
#pragma once

#include "rewrite/rewrite.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <map>
#include <ostream>

namespace symreal::tool {

// Counts of the word `double`, by fate.
struct Tally {
  std::array<std::size_t, 5> counts{}; // by Fate
  std::size_t floats = 0, long_doubles = 0;

  std::size_t operator[](rewrite::Fate fate) const { return counts[static_cast<std::size_t>(fate)]; }
  std::size_t converted() const { return (*this)[rewrite::Fate::converted] + (*this)[rewrite::Fate::follows]; }
  std::size_t compiled() const {
    return converted() + (*this)[rewrite::Fate::passive] + (*this)[rewrite::Fate::diagnosed];
  }
  std::size_t all() const { return compiled() + (*this)[rewrite::Fate::inactive]; }
  Tally &operator+=(Tally const &other);
};

Tally tally(std::vector<rewrite::Spelling> const &ledger);

// Prints the report; with `list`, every place.
void print_readiness(std::ostream &out, rewrite::Request const &request, rewrite::Result const &result, bool list);
nlohmann::ordered_json readiness_json(rewrite::Request const &request, rewrite::Result const &result);

// SARIF 2.1.0: obstacles, and dependences on values.
nlohmann::ordered_json sarif(rewrite::Result const &result);

} // namespace symreal::tool
