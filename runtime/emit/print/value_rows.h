// The table of a loop's values: a row for each iteration of a period, of which each is written down once.
#pragma once

#include <cstdint>
#include <vector>

namespace symreal {

struct ValueRows {
  std::vector<std::vector<double> const *> columns = {};
  std::vector<std::uint32_t> written = {}; // rows, in order
  // Per row which of those it is; empty where most rows differ, so that all are written.
  std::vector<std::uint32_t> which = {};

  bool is_listed() const { return !which.empty(); }
};

// Fills what follows from the columns, which are equally long.
void write_once(ValueRows &rows);

} // namespace symreal
