#include "engine/plan/reroll/mirrors.h"

#include <cmath>
#include <cstdlib>

namespace symreal::reroll {

namespace {

constexpr std::uint32_t least_rows = 16;

class Matrix {
public:
  Matrix(std::vector<NodeId> const &stored, std::uint32_t first, std::uint32_t rows)
      : stored_(stored),
        first_(first),
        rows_(rows) {}

  bool is_symmetric() const {
    for (std::uint32_t row = 0; row < rows_; ++row)
      for (std::uint32_t column = 0; column < row; ++column)
        if (at(row, column) != at(column, row)) return false;
    return true;
  }

  // Whether consecutive iterations of loops compute more row neighbours than column neighbours above the diagonal.
  bool is_by_rows(Memory const &memory) const {
    std::int64_t surplus = 0;
    for (std::uint32_t row = 0; row < rows_; ++row)
      for (std::uint32_t column = row + 1; column < rows_; ++column) {
        if (column + 1 < rows_) surplus += are_in_turn(memory, at(row, column), at(row, column + 1));
        if (row + 1 < column) surplus -= are_in_turn(memory, at(row, column), at(row + 1, column));
      }
    return surplus >= 0;
  }

private:
  NodeId at(std::uint32_t row, std::uint32_t column) const { return stored_[first_ + rows_ * row + column]; }

  static bool are_in_turn(Memory const &memory, NodeId a, NodeId b) {
    std::optional<Cell> const one = memory.cell(a), other = memory.cell(b);
    return one && other && one->loop == other->loop && one->position == other->position &&
           std::abs(one->iteration - other->iteration) == 1;
  }

  std::vector<NodeId> const &stored_;
  std::uint32_t first_, rows_;
};

// Dimension of the square matrices in the object, or of the one that a flat array of its size forms; 0 if not square.
std::uint32_t rows_of(Object const &object) {
  std::vector<std::size_t> const &extents = object.extents;
  if (extents.empty() || !object.members.empty()) return 0;
  if (extents.size() > 1) return extents.back() == extents.end()[-2] ? static_cast<std::uint32_t>(extents.back()) : 0;
  auto const rows = static_cast<std::uint32_t>(std::lround(std::sqrt(object.count)));
  return rows * rows == object.count ? rows : 0;
}

} // namespace

std::vector<Mirror> mirrors(std::vector<Object> const &objects, std::vector<NodeId> const &stored,
                            Memory const &memory) {
  std::vector<Mirror> found;
  for (Object const &object : objects) {
    std::uint32_t const rows = rows_of(object);
    if (rows < least_rows) continue;
    for (std::uint32_t first = object.first; first < object.first + object.count; first += rows * rows)
      if (Matrix const matrix(stored, first, rows); matrix.is_symmetric())
        found.push_back({first, rows, matrix.is_by_rows(memory)});
  }
  return found;
}

} // namespace symreal::reroll
