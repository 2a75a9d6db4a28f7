// Outputs that are sums of many numbers, as the numbers themselves: each depends on few inputs, where the sum depends
// on all of them, and the derivative of the sum is the sum of the derivatives.
#pragma once

#include "engine/optimise/differentiate/structure.h"

#include <span>
#include <vector>

namespace symreal {

struct Addend {
  std::uint32_t term; // its number
  long double factor;
};

class Addends {
public:
  // `outputs`: slots.
  Addends(Graph const &graph, std::vector<std::uint32_t> outputs);

  std::vector<NodeId> const &terms() const { return terms_; }
  // The slots of the inputs that each term depends on.
  Pattern const &inputs() const { return inputs_; }
  // One that would gain nothing is its own only term. Constants and parameters are left out.
  std::vector<Addend> const &of(std::uint32_t output) const;
  // How many terms of one output have an input in common.
  std::size_t overlap() const { return overlap_; }

private:
  std::vector<std::uint32_t> outputs_; // ascending
  std::vector<std::vector<Addend>> addends_;
  std::vector<NodeId> terms_;
  Pattern inputs_;
  std::size_t overlap_ = 1;
};

} // namespace symreal
