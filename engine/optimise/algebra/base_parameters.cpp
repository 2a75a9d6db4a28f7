#include "engine/optimise/algebra/base_parameters.h"

#include "engine/optimise/algebra/parameter_columns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace symreal::algebra {

namespace {

// Reduced row echelon form: each row starts with a 1, in a column that is 0 in all other rows.
class Elimination {
public:
  explicit Elimination(std::size_t columns) : pivot_row_(columns, none) {}

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
  using Row = std::vector<long double>;
  // `rows` hold the base columns, then the other columns.
  LeastSquares(std::vector<Row> rows, std::size_t base) : rows_(std::move(rows)), base_(base) {
    for (std::size_t column = 0; column < base_; ++column) reflect(column);
  }

  // Coefficients of the base columns in column `base_ + other`.
  Row shares(std::size_t other) const {
    Row result(base_, 0);
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
    Row normal(rows_.size(), 0);
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

  std::vector<Row> rows_;
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
  Elimination elimination(count);
  std::vector<LeastSquares::Row> numbers;
  for (std::uint64_t point = 0, idle = 0; idle < patience && elimination.rank() < count; ++point) {
    columns.make_rows(point);
    std::size_t const before = elimination.rank();
    for (std::vector<Residue> const &row : columns.residues()) elimination.add(row);
    numbers.insert(numbers.end(), columns.numbers().begin(), columns.numbers().end());
    idle = elimination.rank() == before ? idle + 1 : 0;
  }
  std::vector<std::size_t> order, others;
  for (std::size_t column = 0; column < count; ++column)
    (elimination.is_base(column) ? order : others).push_back(column);
  std::size_t const base = order.size();
  if (others.empty()) return {};
  order.insert(order.end(), others.begin(), others.end());
  for (LeastSquares::Row &row : numbers) {
    LeastSquares::Row sorted;
    for (std::size_t column : order) sorted.push_back(row[column]);
    row = std::move(sorted);
  }
  LeastSquares const fit(std::move(numbers), base);
  std::vector<LeftOut> result;
  for (std::size_t k = 0; k < others.size(); ++k) {
    result.push_back({others[k], {}});
    LeastSquares::Row const shares = fit.shares(k);
    for (std::size_t i = 0; i < base; ++i) {
      Residue const residue = elimination.share(order[i], others[k]);
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

class Substitution {
public:
  Substitution(Network const &network, ParameterColumns const &columns)
      : network_(network),
        columns_(columns),
        result_(network.context()),
        as_it_was_(network.size()),
        now_(network.size()) {}

  Network run(std::vector<LeftOut> const &left_out) {
    auto old = [&](Literal literal) { return as_it_was_[literal.node()].negated_if(literal.is_negative()); };
    auto now = [&](Literal literal) { return now_[literal.node()].negated_if(literal.is_negative()); };
    for (Index node = 0; node < network_.size(); ++node)
      if (network_[node].is_free()) now_[node] = as_it_was_[node] = result_.copy(network_, network_[node], old);
    std::vector<Index> const &parameters = columns_.parameters();
    for (LeftOut const &one : left_out) {
      Index const from = parameters[one.column];
      for (auto const &[base, share] : one.shares) {
        Literal &sum = now_[parameters[base]];
        sum = result_.sum(sum, result_.product(result_.constant(share), as_it_was_[from]));
      }
      now_[from] = result_.zero();
    }
    for (Index node = 0; node < network_.size(); ++node)
      if (!network_[node].is_free() || columns_.is_sum(node)) now_[node] = result_.copy(network_, network_[node], now);
    for (Literal root : network_.roots) result_.roots.push_back(now(root));
    return std::move(result_);
  }

private:
  Network const &network_;
  ParameterColumns const &columns_;
  Network result_;
  std::vector<Literal> as_it_was_, now_;
};

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
  Network result = Substitution(network, columns).run(left_out);
  for (std::size_t i = 0; i < network.roots.size(); ++i) {
    Value const before = network.value(network.roots[i]), after = result.value(result.roots[i]);
    if (!equal_in_field(before, after) || !confirmed(before, after, scale_of(before))) return std::nullopt;
  }
  return result;
}

} // namespace symreal::algebra
