// Bisection of a difference: the first pass, and its first rewrite, that changes an output of a sample.
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
  std::size_t output = 0; // output slot
  double before = 0, after = 0;
  std::size_t rewrites = 0;          // number of the first rewrite at fault; 0: the pass does not rewrite node by node
  std::string rule = {};             // "(mul x 0) -> 0", or that constants were folded
  LocationId location = no_location; // of the rewritten node
};

// Default passes of a mode.
std::vector<NamedPass> default_pipeline(FloatingPoint mode);

// The first pass that changes an output beyond `mode` and `tolerance`; nullopt if no pass does. `graph` calls no
// function of a program.
std::optional<Culprit> find_culprit(Graph const &graph, std::vector<NamedPass> const &passes,
                                    PassSettings const &settings, double tolerance, Sample const &sample);

} // namespace symreal::program
