// Inputs and parameters on which the original and the generated code are compared: the recorded values, values around
// them, wide magnitudes, and corners; for code with guards, which often ask for zeros, also samples that are mostly
// zero. The same seed gives the same samples on every host.
#pragma once

#include "engine/graph/graph.h"

#include <cstdint>
#include <vector>

namespace symreal {

struct Sample {
  std::vector<double> inputs, parameters;
  bool operator==(Sample const &) const = default;
};

class SampleSource {
public:
  // `only_near`: without wide magnitudes and corners; an input with a range still covers all of it.
  SampleSource(Graph const &graph, std::uint64_t seed, bool only_near = false);
  // The first is the recorded one.
  Sample next();

private:
  // Distribution of one number.
  struct Slot {
    double recorded;
    std::optional<Range> range;
  };
  enum class Way { recorded, near, wide, corner, sparse };

  double draw(Slot const &slot, Way way, bool is_parameter);
  double near(double recorded);
  double wide();
  double corner(Slot const &slot);
  std::uint64_t bits();
  double uniform(double low, double high);

  std::vector<Slot> inputs_, parameters_;
  bool guarded_, only_near_;
  std::uint64_t state_;
  std::size_t drawn_ = 0;
};

} // namespace symreal
