// Stores of the results of a function: at once, as mirror images of others, or by copies at the end.
//
// Arrays may overlap, so all inputs must be read, and all guards checked, before a result is stored. Direct results,
// which a step stores as soon as it has computed them, are therefore those of a function without guards that are
// computed behind the last read of an input. The others wait in memory until the end.
//
// A loop over half of a symmetric matrix stores contiguously by rows or by columns, not both, so stores to the other
// half would each touch another cache line. The other half is therefore copied at the end, in blocks.
#pragma once

#include "engine/plan/reroll/memory.h"

namespace symreal::reroll {

// `objects`: objects whose elements the results `stored` are.
std::vector<Mirror> mirrors(std::vector<Object> const &objects, std::vector<NodeId> const &stored,
                            Memory const &memory);

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

// Nodes to copy and their target elements: in memory, or in the outputs of the function.
struct Copies {
  std::vector<NodeId> nodes;
  std::vector<std::uint32_t> places;
  bool are_results;
};

// Adds the copies; as loops where sources and targets advance by constant steps.
void add_copies(Graph const &graph, Copies const &copies, Memory const &memory, std::vector<LoopStep> &steps);

// Adds the last steps of a function. `done`: per result whether a step, or a mirror, stores it.
void add_result_copies(Graph const &graph, std::vector<NodeId> const &stored, std::vector<char> const &done,
                       Memory const &memory, std::vector<LoopStep> &steps);

} // namespace symreal::reroll
