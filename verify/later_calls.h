// Further calls of a kernel in a row, on inputs and parameters of their own: state that a first call makes from its
// inputs, and that later calls keep, shows in no other way.
#pragma once

#include "engine/graph/evaluate.h"
#include "verify/generated_code.h"
#include "verify/replay.h"

#include <functional>
#include <vector>

namespace symreal::program {

struct LaterCall {
  Sample sample;               // as the generated code is given it: state is what the call before it gave
  std::vector<double> outputs; // of the generated code
};

class LaterCalls {
public:
  // `run`: the generated code.
  LaterCalls(Graph const &graph, FloatingPoint mode, std::uint64_t seed,
             std::function<GeneratedCode::Result(Sample const &)> run)
      : graph_(graph),
        mode_(mode),
        seed_(seed),
        run_(std::move(run)) {}

  // Calls within the premises and all guards, after one on `first` that gave `outputs`. The same for the same sample.
  // Fewer than Replay::most_later where no such sample is found in a few draws.
  std::vector<LaterCall> inside(Replay const &original, Sample const &first, std::span<double const> outputs) const;

  // The same call where the one before it gave these outputs; nullopt outside of the premises and guards.
  std::optional<LaterCall> after(Replay const &original, Sample sample, std::span<double const> outputs) const;

  // A sample on which the original has a meaning and some guard fails, after the same call; nullopt if none is drawn.
  std::optional<Sample> beyond_guards(Replay const &original, Sample const &first,
                                      std::span<double const> outputs) const;

private:
  std::uint64_t seed_of(Sample const &first) const;

  Graph const &graph_;
  FloatingPoint mode_;
  std::uint64_t seed_;
  std::function<GeneratedCode::Result(Sample const &)> run_;
};

} // namespace symreal::program
