// Conversion between graphs and networks.
#pragma once

#include "engine/graph/graph.h"
#include "engine/ops/operation.h"
#include "engine/optimise/algebra/key_table.h"
#include "engine/optimise/algebra/network.h"

#include <bit>

namespace symreal::algebra {

// Constant forms: derivation of a program's constants from one another.
//
// The compiler rounded constant expressions before recording: where the source multiplied a mass by an offset, the
// graph has one number. Without the product, algebra cannot see that the two halves of a matrix are equal, nor that a
// difference is 0. So a constant that is, to the last bit, the rounded sum, product or quotient of others, or a product
// added to a number, is replaced by that form. A chance match has probability 2^-52 per pair of numbers.
enum class FormKind : std::uint8_t { sum, product, quotient, sum_with_product };

// a + b, a * b, a / b, or a + b * c, up to sign.
struct ConstantForm {
  FormKind kind;
  double a, b, c = 0;
};

class ConstantForms {
public:
  // `constants` are magnitudes in order of occurrence; among thousands, only near ones are compared. A form
  // of earlier constants wins over other matching ones: a quotient is derived from its dividend, not the reverse.
  explicit ConstantForms(std::span<double const> constants);

  // The form of a constant, else null. Forms do not form cycles.
  ConstantForm const *find(double magnitude) const;

private:
  struct Product {
    double value, a, b;
  };
  static constexpr int deepest = 4;

  void look_at_pairs();
  void look_at_products();
  void propose(double value, ConstantForm const &form);
  bool rests_on(double constant, double other, int depth) const;
  // Index among the constants; KeyTable::none if absent.
  std::uint32_t place_of(double magnitude) const { return place_.find(std::bit_cast<std::uint64_t>(magnitude)); }

  std::vector<double> constants_;
  std::vector<std::optional<ConstantForm>> forms_; // per constant
  KeyTable place_;
  bool only_earlier_ = true;
};

// Network of a graph. Sums, differences, products, quotients and negations are algebra unless exact; all other
// operations are opaque. The roots are those of the graph, in its order.
Network network_of(Graph const &graph, CostModel const &costs = usual_costs());

// Graph of a network, equivalent to `graph`. Returns nullopt if a constant exceeds the range of a double.
std::optional<Graph> graph_of(Network const &network, Graph const &graph);

} // namespace symreal::algebra
