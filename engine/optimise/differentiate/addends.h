// Addends: decomposition of outputs that are sums. Each addend depends on few inputs, the sum on all of them, and the
// derivative of the sum is the sum of the derivatives.
#pragma once

#include "engine/optimise/differentiate/structure.h"

#include <span>
#include <vector>

namespace symreal {

struct Addend {
  std::uint32_t term; // index into Addends::terms()
  long double factor;
};

class Addends {
public:
  // `outputs` are slots.
  Addends(Graph const &graph, std::vector<std::uint32_t> outputs);

  std::vector<NodeId> const &terms() const { return terms_; }
  // Input slots that each term depends on.
  Pattern const &inputs() const { return inputs_; }
  // Addends of an output, without constants and parameters; the output itself if its decomposition gains nothing.
  std::vector<Addend> const &of(std::uint32_t output) const;
  // Largest number of terms of one output that share an input.
  std::size_t overlap() const { return overlap_; }

private:
  std::vector<std::uint32_t> outputs_; // ascending
  std::vector<std::vector<Addend>> addends_;
  std::vector<NodeId> terms_;
  Pattern inputs_;
  std::size_t overlap_ = 1;
};

} // namespace symreal
