// The oracle: a second recording that shares nothing with the rewriter but the places of the annotations. Clang
// compiles the original, a pass (rewrite/instrument/plugin.cpp) makes its instructions on doubles record themselves.
#pragma once

#include "program/record/front.h"
#include "runtime/replay/compare.h"
#include "runtime/replay/samples.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

// Builds and records the kernels of the front from the instructions of their original, in their order; a decision is a
// guard. The recorder's diagnostics come with them. Throws oracle_not_possible, also where a kernel calls functions of
// the program, and build_failed.
Recording record_instructions(Front const &front, RunOptions run, LineSink const &sink);

struct OracleOptions {
  std::size_t samples = 1000, min_samples = 100;
  std::uint64_t seed = 1;
  FloatingPoint mode = FloatingPoint::finite;
};

// Two recordings of one kernel.
struct OracleComparison {
  std::size_t operations = 0, oracle_operations = 0;
  std::size_t samples = 0; // within the premises of the mode and the guards of both
  std::size_t outside = 0; // the others
  std::vector<OutputComparison> outputs;
  // Source lines of operations that the oracle needs and whose values are none of the recorded graph's: how many.
  std::map<std::string, std::size_t> only_oracle;
};

// Throws oracle_mismatch for another shape.
OracleComparison compare_recordings(Graph const &graph, Graph const &oracle, OracleOptions const &options);

} // namespace symreal::program
