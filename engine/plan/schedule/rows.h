// Rows of statement numbers, one row per statement, contiguous in one array (compressed sparse rows).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace symreal {

struct Rows {
  std::vector<std::size_t> first = {0};
  std::vector<std::uint32_t> all = {};

  std::size_t size() const { return first.size() - 1; }
  std::span<std::uint32_t const> operator[](std::size_t k) const {
    return std::span(all).subspan(first[k], first[k + 1] - first[k]);
  }
  void end_row() { first.push_back(all.size()); }
};

// Transpose: row k lists, in ascending order, the rows that contain k.
inline Rows transposed(Rows const &rows) {
  Rows result{std::vector<std::size_t>(rows.size() + 1, 0), std::vector<std::uint32_t>(rows.all.size())};
  for (std::uint32_t const k : rows.all) ++result.first[k + 1];
  for (std::size_t k = 0; k < rows.size(); ++k) result.first[k + 1] += result.first[k];
  std::vector<std::size_t> next = result.first;
  for (std::uint32_t row = 0; row < rows.size(); ++row)
    for (std::uint32_t const k : rows[row]) result.all[next[k]++] = row;
  return result;
}

} // namespace symreal
