#include "engine/optimise/differentiate/linear_system.h"

#include <utility>

namespace symreal {

SquareMatrix transposed(SquareMatrix const &matrix) {
  SquareMatrix result = matrix;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j) result[j][i] = matrix[i][j];
  return result;
}

namespace {

class Elimination {
public:
  Elimination(Expressions &expressions, SquareMatrix matrix, std::vector<NodeId> right)
      : expressions_(expressions),
        rows_(std::move(matrix)),
        count_(right.size()) {
    for (std::size_t i = 0; i < count_; ++i) rows_[i].push_back(right[i]); // augmented matrix
  }

  std::optional<std::vector<NodeId>> run() {
    for (std::size_t k = 0; k < count_; ++k) {
      if (!choose_pivot(k)) return std::nullopt;
      for (std::size_t i = k + 1; i < count_; ++i) eliminate(i, k);
    }
    std::vector<NodeId> result(count_, no_node);
    for (std::size_t k = count_; k-- > 0;) {
      NodeId sum = rows_[k][count_];
      for (std::size_t j = k + 1; j < count_; ++j) sum = less(sum, rows_[k][j], result[j]);
      result[k] = expressions_.quotient(sum, rows_[k][k]);
    }
    return result;
  }

private:
  bool choose_pivot(std::size_t k) {
    std::size_t first = k;
    while (first < count_ && rows_[first][k] == no_node) ++first;
    if (first == count_) return false;
    std::swap(rows_[k], rows_[first]);
    for (std::size_t i = first + 1; i < count_; ++i) {
      if (rows_[i][k] == no_node) continue;
      NodeId const is_larger = expressions_.is_larger_magnitude(rows_[i][k], rows_[k][k]);
      for (std::size_t j = k; j <= count_; ++j) {
        NodeId const upper = rows_[k][j], lower = rows_[i][j];
        rows_[k][j] = expressions_.choice(is_larger, lower, upper);
        rows_[i][j] = expressions_.choice(is_larger, upper, lower);
      }
    }
    return true;
  }

  void eliminate(std::size_t i, std::size_t k) {
    if (rows_[i][k] == no_node) return;
    NodeId const factor = expressions_.quotient(rows_[i][k], rows_[k][k]);
    for (std::size_t j = k + 1; j <= count_; ++j) rows_[i][j] = less(rows_[i][j], factor, rows_[k][j]);
    rows_[i][k] = no_node;
  }

  // a - b c
  NodeId less(NodeId a, NodeId b, NodeId c) {
    return expressions_.sum(a, expressions_.negative(expressions_.product(b, c)));
  }

  Expressions &expressions_;
  SquareMatrix rows_;
  std::size_t count_;
};

} // namespace

std::optional<std::vector<NodeId>> solve(Expressions &expressions, SquareMatrix matrix, std::vector<NodeId> right) {
  return Elimination(expressions, std::move(matrix), std::move(right)).run();
}

} // namespace symreal
