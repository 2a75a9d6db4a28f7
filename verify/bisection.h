// Which pass, and in it which rewrite, is the first to give other outputs on a sample than the recorded graph.
#pragma once

#include "engine/optimise/passes/pass.h"
#include "runtime/replay/samples.h"

#include <functional>
#include <optional>
#include <string>

namespace symreal::program {

struct NamedPass {
  std::string name;
  std::function<Graph(Graph const &, PassSettings const &)> run;
};

struct Culprit {
  std::string pass = {};
  std::size_t output = 0; // slot
  double before = 0, after = 0;
  std::size_t rewrites = 0; // the number of the rewrite that does it; 0: the pass does not rewrite node by node
  std::string rule = {};    // "(mul x 0) -> 0", or that constants were folded
  LocationId location = no_location; // of what was rewritten
};

// The default passes of a mode.
std::vector<NamedPass> default_pipeline(FloatingPoint mode);

// Outputs are the same by `mode` and `tolerance`. Nothing where no pass changes them. `graph` calls no function of a
// program.
std::optional<Culprit> find_culprit(Graph const &graph, std::vector<NamedPass> const &passes,
                                    PassSettings const &settings, double tolerance, Sample const &sample);

} // namespace symreal::program
