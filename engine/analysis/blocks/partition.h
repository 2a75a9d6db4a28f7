// A task graph cut into blocks of about the same work, such that few values cross. Components that can be shared out
// evenly are: then nothing crosses. Else METIS cuts (G. Karypis and V. Kumar, 1998), which does not look at directions.
#pragma once

#include "engine/analysis/blocks/components.h"

namespace symreal {

using BlockId = std::uint32_t;

struct Blocks {
  std::uint32_t count = 0;
  std::vector<BlockId> of_task; // numbered by their first tasks

  BlockId operator[](TaskId task) const { return of_task[task]; }
};

// Work is the tasks' durations. Each block has a task that lasts some time: `count` is at least 1 and at most as many
// as there are of these. The same graph gives the same blocks. Throws bad_option where METIS gives up.
Blocks partition(TaskGraph const &graph, Components const &components, std::uint32_t count);

} // namespace symreal
