// Cut points of a long function body.
#pragma once

#include "engine/plan/schedule/rows.h"
#include "engine/plan/schedule/schedule.h"

#include <cstdint>
#include <vector>

namespace symreal {

class Cuts {
public:
  Cuts(Schedule const &plan, FunctionBody const &body, bool in_compute);

  // Begins of the chunks of these statements. A chunk has at most `most_statements` and, except for the last, at least
  // half as many; it ends where the fewest values per statement cross its borders. Linear time.
  std::vector<std::size_t> between(std::size_t first, std::size_t end, std::size_t most_statements);

private:
  std::size_t best_end(std::size_t begin, std::size_t most_statements);

  // Per statement: the earlier statements whose values it reads, and those that it reads last.
  Rows reads_, dying_;
  std::vector<std::uint32_t> loaded_by_; // per statement: begin of the last chunk found to read it
};

} // namespace symreal
