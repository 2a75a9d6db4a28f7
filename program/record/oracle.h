// The oracle: a second recording, independent of the rewriter except for the places of annotations. Clang compiles the
// original, and a pass (rewrite/instrument/plugin.cpp) makes its instructions on doubles record themselves.
#pragma once

#include "program/record/front.h"
#include "runtime/replay/compare.h"
#include "runtime/replay/samples.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::program {

// Records the front's kernels from the instructions of their original, in their order; decisions become guards. The
// recorder's diagnostics are included. Throws oracle_not_possible, also for kernels that call functions of the program,
// and build_failed.
Recording record_instructions(Front const &front, RunOptions run, LineSink const &sink);

struct OracleOptions {
  std::size_t samples = 1000, min_samples = 100;
  std::uint64_t seed = 1;
  FloatingPoint mode = FloatingPoint::finite;
};

// Comparison of two recordings of one kernel.
struct OracleComparison {
  std::size_t operations = 0, oracle_operations = 0;
  std::size_t samples = 0; // samples within the premises of the mode and the guards of both recordings
  std::size_t outside = 0; // other samples
  std::vector<OutputComparison> outputs;
  // Per source line: operations that the oracle needs and whose values the recorded graph lacks.
  std::map<std::string, std::size_t> only_oracle;
};

// Throws oracle_mismatch if the interfaces differ.
OracleComparison compare_recordings(Graph const &graph, Graph const &oracle, OracleOptions const &options);

} // namespace symreal::program
