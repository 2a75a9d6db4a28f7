// Where a long function body is cut.
#pragma once

#include "engine/plan/schedule/rows.h"
#include "engine/plan/schedule/schedule.h"

#include <cstdint>
#include <vector>

namespace symreal {

class Cuts {
public:
  Cuts(Schedule const &plan, FunctionBody const &body, bool in_compute);

  // Where the chunks of these statements begin. None has more than so many, nor, but for the last, less than half of
  // that: it ends where the fewest values for its length come in from others and go out to them. Linear.
  std::vector<std::size_t> between(std::size_t first, std::size_t end, std::size_t most_statements);

private:
  std::size_t best_end(std::size_t begin, std::size_t most_statements);

  // Per statement: the earlier ones whose values it reads, and those that nobody reads behind it.
  Rows reads_, dying_;
  std::vector<std::uint32_t> loaded_by_; // per statement: the beginning of the chunk that was last found to read it
};

} // namespace symreal
