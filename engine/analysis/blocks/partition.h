// Partition of a task graph into blocks of similar work with few crossing values. Whole components are distributed if
// that is balanced. Else METIS cuts the graph (G. Karypis and V. Kumar, 1998), ignoring edge directions.
#pragma once

#include "engine/analysis/blocks/components.h"

namespace symreal {

using BlockId = std::uint32_t;

struct Blocks {
  std::uint32_t count = 0;
  std::vector<BlockId> of_task; // numbered in order of their first tasks

  BlockId operator[](TaskId task) const { return of_task[task]; }
};

// Work is the tasks' durations. Each block gets a task of nonzero duration; `count` is at least 1 and at most the
// number of these. Deterministic. Throws bad_option if METIS fails.
Blocks partition(TaskGraph const &graph, Components const &components, std::uint32_t count);

} // namespace symreal
