// Direct results: those that a step stores as soon as it has computed them.
//
// Arrays may overlap, so all inputs must be read, and all guards checked, before a result is stored. Direct results are
// therefore those of a function without guards that are computed behind the last read of an input. The others wait in
// memory until the end (copies.h).
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// An operation of a loop body that computes a result in every iteration.
struct LoopResult {
  std::uint32_t position;
  Access access;
};

struct DirectResults {
  std::vector<std::vector<LoopResult>> of_loop;              // per loop
  std::map<NodeId, std::vector<std::uint32_t>> of_operation; // of straight pieces: results per operation
  std::vector<char> is_stored;                               // per result: by a step, or by a mirror
};

// `begin`: sequence position of the first step that may store results. `mirrors`: results that they copy are skipped.
DirectResults direct_results(Sequence const &sequence, std::vector<LoopBody> const &loops,
                             std::vector<NodeId> const &stored, std::vector<Mirror> const &mirrors,
                             Memory const &memory, std::size_t begin);

} // namespace symreal::reroll
