// Which results the steps of a function store themselves, as soon as they have them.
//
// All inputs are read before a result is stored, since the arrays may overlap, and all checks are made. So it is what
// steps compute behind the last one that reads an input, of a function without guards. The rest waits in memory until
// the end (copies.h).
#pragma once

#include "engine/plan/reroll/loop_program.h"
#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// An operation of the body of a loop, of which every iteration computes a result.
struct LoopResult {
  std::uint32_t position;
  Access access;
};

struct DirectResults {
  std::vector<std::vector<LoopResult>> of_loop;              // per loop
  std::map<NodeId, std::vector<std::uint32_t>> of_operation; // of straight stretches: the results that it is
  std::vector<char> is_stored;                               // per result: by one of these, or a mirror copies it
};

// `begin`: where in the sequence the steps begin that may store results. `mirrors`: what they copy is left to them.
DirectResults direct_results(Sequence const &sequence, std::vector<LoopBody> const &loops,
                             std::vector<NodeId> const &stored, std::vector<Mirror> const &mirrors,
                             Memory const &memory, std::size_t begin);

} // namespace symreal::reroll
