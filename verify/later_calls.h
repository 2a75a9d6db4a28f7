// Sequences of calls of a kernel, each with its own inputs and parameters: only they expose state that the first call
// derives from its inputs and later calls keep.
#pragma once

#include "engine/graph/evaluate.h"
#include "verify/generated_code.h"
#include "verify/replay.h"

#include <functional>
#include <vector>

namespace symreal::program {

struct LaterCall {
  Sample sample;               // inputs of the generated code; state holds the outputs of the call before
  std::vector<double> outputs; // outputs of the generated code
};

// Samples that are followed by one beyond the guards, and the time limit of that one: the original may not end there.
inline constexpr std::size_t most_beyond = 100;
inline constexpr unsigned seconds_beyond = 1;

class LaterCalls {
public:
  // `run` calls the generated code.
  LaterCalls(Graph const &graph, FloatingPoint mode, std::uint64_t seed,
             std::function<GeneratedCode::Result(Sample const &)> run)
      : graph_(graph),
        mode_(mode),
        seed_(seed),
        run_(std::move(run)) {}

  // Later calls within the premises and all guards, after a first call on `first` that gave `outputs`; deterministic in
  // `first`. Fewer than Replay::most_later if a few draws find no such sample.
  std::vector<LaterCall> inside(Replay const &original, Sample const &first, std::span<double const> outputs) const;

  // The same call with the state of these outputs; nullopt if it violates the premises or a guard.
  std::optional<LaterCall> after(Replay const &original, Sample sample, std::span<double const> outputs) const;

  // A sample after the same first call on which the original is defined and some guard fails; nullopt if none is drawn.
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
