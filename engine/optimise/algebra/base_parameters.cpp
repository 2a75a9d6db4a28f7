#include "engine/optimise/algebra/base_parameters.h"

#include <cmath>

namespace symreal::algebra {

namespace {

// Arithmetic of one kind of number.
struct InField {
  using Number = Residue;
  static Number zero() { return 0; }
  static Number one() { return 1; }
  static Number sum(Number a, Number b) { return add(a, b); }
  static Number product(Number a, Number b) { return multiply(a, b); }
  static Number quotient(Number a, Number b) { return multiply(a, inverse(b)); }
  static Number signed_by(Literal literal, Number a) { return literal.is_negative() ? negate(a) : a; }
};

struct InNumbers {
  using Number = long double;
  static Number zero() { return 0; }
  static Number one() { return 1; }
  static Number sum(Number a, Number b) { return a + b; }
  static Number product(Number a, Number b) { return a * b; }
  static Number quotient(Number a, Number b) { return a / b; }
  static Number signed_by(Literal literal, Number a) { return literal.is_negative() ? -a : a; }
};

// Parameter columns: coefficients of the parameters in values that are linear in them. A parameter is any node computed
// from parameters and numbers alone, except sums and multiples of others.
class ParameterColumns {
public:
  explicit ParameterColumns(Network const &network)
      : network_(network),
        column_(network.size(), no_index),
        is_linear_(network.size(), 0),
        is_used_(network.size(), 0) {
    std::vector<char> const live = live_nodes(network);
    for (Index node = 0; node < network.size(); ++node)
      if (live[node]) classify(node);
    for (Literal root : network.roots) add_sum(root);
  }

  std::vector<Index> const &parameters() const { return parameters_; }
  // Whether the node is free and a linear combination of parameters.
  bool is_sum(Index node) const { return is_linear_[node] && network_[node].is_free() && !is_parameter(node); }
  // Cost of the rows of one point.
  std::uint64_t work() const { return (sums_.size() + 1) * network_.size(); }

  // Makes one row of coefficients per value at random point `point`, modulo the prime and in extended precision, by a
  // reverse sweep from each sum: its derivative by each linear node.
  void make_rows(std::uint64_t point) {
    evaluate(point);
    residues_.clear();
    numbers_.clear();
    auto row_of = [&]<class In>(In, Index sum, auto const &values) {
      using Number = typename In::Number;
      std::vector<Number> growth(sum + 1, In::zero()), row(parameters_.size(), In::zero());
      growth[sum] = In::one();
      for (Index index = sum + 1; index-- > 0;) {
        Number const all = growth[index];
        if (all == In::zero() || !is_linear_[index]) continue;
        if (is_parameter(index)) {
          row[column_[index]] = all;
          continue;
        }
        NetworkNode const &node = network_[index];
        auto hand_on = [&](Literal literal, Number factor) {
          Number &growth_of = growth[literal.node()];
          if (is_linear_[literal.node()])
            growth_of = In::sum(growth_of, In::signed_by(literal, In::product(all, factor)));
        };
        auto of = [&](Literal literal) { return In::signed_by(literal, values[literal.node()]); };
        if (node.kind == Kind::sum) {
          hand_on(node.a, In::one());
          hand_on(node.b, In::one());
        } else if (node.kind == Kind::product) {
          hand_on(node.a, of(node.b));
          hand_on(node.b, of(node.a));
        } else {
          hand_on(node.a, In::quotient(In::one(), of(node.b)));
        }
      }
      return row;
    };
    for (Index sum : sums_) {
      residues_.push_back(row_of(InField{}, sum, residue_));
      numbers_.push_back(row_of(InNumbers{}, sum, number_));
    }
  }

  std::vector<std::vector<Residue>> const &residues() const { return residues_; }
  std::vector<std::vector<long double>> const &numbers() const { return numbers_; }

private:
  bool is_parameter(Index node) const { return column_[node] != no_index; }

  void classify(Index index) {
    NetworkNode const &node = network_[index];
    if (node.attribute == Attribute::constant) return;
    auto linear = [&](Literal literal) { return is_linear_[literal.node()] != 0; };
    auto is_number = [&](Literal literal) { return network_[literal].attribute == Attribute::constant; };
    if (node.is_free()) {
      // Nodes that may be infinite stay unchanged.
      if (node.hazards != no_hazard) return;
      bool const is_sum =
          node.kind == Kind::sum && (linear(node.a) || is_number(node.a)) && (linear(node.b) || is_number(node.b));
      bool const is_multiple =
          node.kind == Kind::product && (is_number(node.a) || is_number(node.b)) && (linear(node.a) || linear(node.b));
      is_linear_[index] = 1;
      if (is_sum || is_multiple) return;
      column_[index] = static_cast<Index>(parameters_.size());
      parameters_.push_back(index);
      return;
    }
    switch (node.kind) {
    case Kind::sum: is_linear_[index] = linear(node.a) || linear(node.b); break;
    case Kind::product:
      is_linear_[index] = linear(node.a) != linear(node.b);
      if (!linear(node.a) || !linear(node.b)) break;
      add_sum(node.a);
      add_sum(node.b);
      break;
    case Kind::quotient:
      is_linear_[index] = linear(node.a) && !linear(node.b);
      if (!linear(node.b)) break;
      add_sum(node.a);
      add_sum(node.b);
      break;
    default: network_.for_each_operand(node, [&](Literal operand) { add_sum(operand); });
    }
  }

  // Records a linear value that a nonlinear node uses, so that it must keep its value.
  void add_sum(Literal literal) {
    Index const node = literal.node();
    if (is_linear_[node] && !std::exchange(is_used_[node], char{1})) sums_.push_back(node);
  }

  // Evaluates all nodes at a point, where inputs and parameters get new random values; nonlinear nodes may depend on
  // parameters.
  void evaluate(std::uint64_t point) {
    residue_.assign(network_.size(), 0);
    number_.assign(network_.size(), 0);
    for (Index index = 0; index < network_.size(); ++index) {
      NetworkNode const &node = network_[index];
      auto compute = [&]<class In>(In, auto &values) {
        auto of = [&](Literal literal) { return In::signed_by(literal, values[literal.node()]); };
        if (node.kind == Kind::sum) values[index] = In::sum(of(node.a), of(node.b));
        if (node.kind == Kind::product) values[index] = In::product(of(node.a), of(node.b));
        if (node.kind == Kind::quotient) values[index] = In::quotient(of(node.a), of(node.b));
      };
      if (node.attribute == Attribute::constant) {
        residue_[index] = node.value.field[0];
        number_[index] = node.value.number[0];
      } else if (node.is_arithmetic()) {
        compute(InField{}, residue_);
        compute(InNumbers{}, number_);
      } else {
        Value value = random_value(mixed(node.value.field[0]) + point);
        if (node.kind == Kind::function) {
          OpaqueFunction const &function = network_.function_of(node);
          Literal const angle = function.operands[0];
          Value operand{};
          operand.field[0] = InField::signed_by(angle, residue_[angle.node()]);
          operand.number[0] = InNumbers::signed_by(angle, number_[angle.node()]);
          if (function.op == Op::sin) value = sine(operand);
          if (function.op == Op::cos) value = cosine(operand);
        }
        residue_[index] = value.field[0];
        number_[index] = value.number[0];
      }
    }
  }

  Network const &network_;
  std::vector<Index> column_;   // per node: its parameter's number, or no_index
  std::vector<char> is_linear_; // per node: linear in parameters
  std::vector<char> is_used_;   // per node: used by a nonlinear node
  std::vector<Index> parameters_, sums_;
  std::vector<Residue> residue_;    // per node
  std::vector<long double> number_; // per node
  std::vector<std::vector<Residue>> residues_;
  std::vector<std::vector<long double>> numbers_;
};

// Reduced row echelon form: each row starts with a 1, in a column that is 0 in all other rows.
class EchelonForm {
public:
  explicit EchelonForm(std::size_t columns) : pivot_row_(columns, none) {}

  std::size_t rank() const { return rows_.size(); }
  bool is_base(std::size_t column) const { return pivot_row_[column] != none; }
  // Coefficient of column `base` in `column`.
  Residue share(std::size_t base, std::size_t column) const { return rows_[pivot_row_[base]][column]; }

  void add(std::vector<Residue> row) {
    for (std::size_t column = 0; column < row.size(); ++column)
      if (row[column] != 0 && is_base(column)) subtract_from(row, rows_[pivot_row_[column]], row[column]);
    std::size_t first = 0;
    while (first < row.size() && row[first] == 0) ++first;
    if (first == row.size()) return;
    Residue const scale = inverse(row[first]);
    for (Residue &entry : row) entry = multiply(entry, scale);
    for (std::vector<Residue> &other : rows_)
      if (other[first] != 0) subtract_from(other, row, other[first]);
    pivot_row_[first] = rows_.size();
    rows_.push_back(std::move(row));
  }

private:
  static constexpr std::size_t none = ~std::size_t{0};

  static void subtract_from(std::vector<Residue> &row, std::vector<Residue> const &other, Residue times) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = subtract(row[i], multiply(times, other[i]));
  }

  std::vector<std::vector<Residue>> rows_;
  std::vector<std::size_t> pivot_row_; // per column
};

// The same coefficients as numbers, by least squares with Householder reflections, since elimination in a given order
// loses digits.
class LeastSquares {
public:
  using Coefficients = std::vector<long double>;
  // `rows` hold the base columns, then the other columns.
  LeastSquares(std::vector<Coefficients> rows, std::size_t base) : rows_(std::move(rows)), base_(base) {
    for (std::size_t column = 0; column < base_; ++column) reflect(column);
  }

  // Coefficients of the base columns in column `base_ + other`.
  Coefficients shares(std::size_t other) const {
    Coefficients result(base_, 0);
    for (std::size_t i = base_; i-- > 0;) {
      long double rest = rows_[i][base_ + other];
      for (std::size_t j = i + 1; j < base_; ++j) rest -= rows_[i][j] * result[j];
      result[i] = rest / rows_[i][i];
    }
    return result;
  }

private:
  void reflect(std::size_t column) {
    long double square = 0;
    for (std::size_t i = column; i < rows_.size(); ++i) square += rows_[i][column] * rows_[i][column];
    long double const length = rows_[column][column] > 0 ? -std::sqrt(square) : std::sqrt(square);
    Coefficients normal(rows_.size(), 0);
    for (std::size_t i = column; i < rows_.size(); ++i) normal[i] = rows_[i][column];
    normal[column] -= length;
    long double const scale = square - rows_[column][column] * length;
    if (scale == 0) return;
    for (std::size_t j = column; j < rows_[column].size(); ++j) {
      long double along = 0;
      for (std::size_t i = column; i < rows_.size(); ++i) along += normal[i] * rows_[i][j];
      along /= scale;
      for (std::size_t i = column; i < rows_.size(); ++i) rows_[i][j] -= along * normal[i];
    }
  }

  std::vector<Coefficients> rows_;
  std::size_t base_;
};

// A redundant parameter, and its shares in other parameters.
struct LeftOut {
  std::size_t column;
  std::vector<std::pair<std::size_t, Value>> shares;
};

std::vector<LeftOut> find_left_out(ParameterColumns &columns) {
  constexpr std::size_t patience = 3;
  std::size_t const count = columns.parameters().size();
  EchelonForm echelon(count);
  std::vector<LeastSquares::Coefficients> numbers;
  for (std::uint64_t point = 0, idle = 0; idle < patience && echelon.rank() < count; ++point) {
    columns.make_rows(point);
    std::size_t const before = echelon.rank();
    for (std::vector<Residue> const &row : columns.residues()) echelon.add(row);
    numbers.insert(numbers.end(), columns.numbers().begin(), columns.numbers().end());
    idle = echelon.rank() == before ? idle + 1 : 0;
  }
  std::vector<std::size_t> order, others;
  for (std::size_t column = 0; column < count; ++column) (echelon.is_base(column) ? order : others).push_back(column);
  std::size_t const base = order.size();
  if (others.empty()) return {};
  order.insert(order.end(), others.begin(), others.end());
  for (LeastSquares::Coefficients &row : numbers) {
    LeastSquares::Coefficients sorted;
    for (std::size_t column : order) sorted.push_back(row[column]);
    row = std::move(sorted);
  }
  LeastSquares const fit(std::move(numbers), base);
  std::vector<LeftOut> result;
  for (std::size_t k = 0; k < others.size(); ++k) {
    result.push_back({others[k], {}});
    LeastSquares::Coefficients const shares = fit.shares(k);
    for (std::size_t i = 0; i < base; ++i) {
      Residue const residue = echelon.share(order[i], others[k]);
      if (residue == 0) continue;
      Value value{};
      value.field.fill(residue);
      value.number.fill(shares[i]);
      result.back().shares.emplace_back(order[i], value);
    }
    if (result.back().shares.empty()) result.pop_back(); // only other parameters use it
  }
  return result;
}

Network without(std::vector<LeftOut> const &left_out, Network const &network, ParameterColumns const &columns) {
  Network result(network.context());
  LiteralMap as_it_was(network.size()), now(network.size());
  for (Index node = 0; node < network.size(); ++node)
    if (network[node].is_free()) now[node] = as_it_was[node] = result.copy(network, network[node], as_it_was);
  std::vector<Index> const &parameters = columns.parameters();
  for (LeftOut const &one : left_out) {
    Index const from = parameters[one.column];
    for (auto const &[base, share] : one.shares) {
      Literal &sum = now[parameters[base]];
      sum = result.sum(sum, result.product(result.constant(share), as_it_was[from]));
    }
    now[from] = result.zero();
  }
  for (Index node = 0; node < network.size(); ++node)
    if (!network[node].is_free() || columns.is_sum(node)) now[node] = result.copy(network, network[node], now);
  for (Literal root : network.roots) result.roots.push_back(now(root));
  return result;
}

} // namespace

std::optional<Network> with_base_parameters(Network const &network, std::size_t *too_many) {
  constexpr std::size_t most_parameters = 400;
  constexpr std::uint64_t most_work = 1'000'000'000; // if each point raises the rank by one
  ParameterColumns columns(network);
  std::size_t const count = columns.parameters().size();
  if (count == 0) return std::nullopt;
  if (count > most_parameters || columns.work() * count > most_work) {
    if (too_many) *too_many = count;
    return std::nullopt;
  }
  std::vector<LeftOut> const left_out = find_left_out(columns);
  if (left_out.empty()) return std::nullopt;
  Network result = without(left_out, network, columns);
  for (std::size_t i = 0; i < network.roots.size(); ++i) {
    Value const before = network.value(network.roots[i]), after = result.value(result.roots[i]);
    if (!equal_in_field(before, after) || !confirmed(before, after, scale_of(before))) return std::nullopt;
  }
  return result;
}

} // namespace symreal::algebra
