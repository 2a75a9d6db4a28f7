// Structure of derivatives: the inputs that a node depends on, the pairs of inputs that it depends on nonlinearly, and
// outputs that are sums. Shares only the operation table with differentiate.h.
#pragma once

#include "engine/graph/graph.h"

#include <span>
#include <vector>

namespace symreal {

// Columns of the structurally nonzero elements of each row, ascending.
using Pattern = std::vector<std::vector<std::uint32_t>>;

// Input slots that each node depends on in any way.
Pattern inputs_of(Graph const &graph, std::span<NodeId const> nodes);

// Sparsity of the Hessian of the nodes together: per input slot, its partners in a second derivative. Symmetric.
Pattern coupled_inputs(Graph const &graph, std::span<NodeId const> nodes);

// Column colouring (Curtis, Powell and Reid): columns of one colour share no row, so the sum of a colour's columns
// shows each of their elements.
struct Colouring {
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> colour; // per column; `none` for an empty column
  std::size_t count = 0;
};
Colouring coloured(Pattern const &rows, std::size_t columns);

// Addends: decomposition of outputs that are sums. Each addend depends on few inputs, the sum on all of them, and the
// derivative of the sum is the sum of the derivatives.
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
