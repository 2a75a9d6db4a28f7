#include "engine/emit/print/matrices.h"

#include "engine/graph/names.h"

#include <algorithm>
#include <numeric>

namespace symreal {

namespace {

// Offsets of `count` lines in a list of elements that is sorted by line.
std::vector<std::size_t> starts(std::vector<std::uint32_t> const &lines, std::size_t count) {
  std::vector<std::size_t> result(count + 1, 0);
  for (std::uint32_t const line : lines) ++result[line + std::size_t{1}];
  std::partial_sum(result.begin(), result.end(), result.begin());
  return result;
}

std::vector<IndexList> index_lists(DerivativeMatrix const &matrix, std::size_t base) {
  std::vector<std::size_t> by_column(matrix.row.size()), row_by_column;
  std::iota(by_column.begin(), by_column.end(), 0);
  std::ranges::stable_sort(by_column, {}, [&](std::size_t k) { return matrix.column[k]; });
  for (std::size_t const k : by_column) row_by_column.push_back(matrix.row[k]);
  std::vector<IndexList> lists = {{"row", {matrix.row.begin(), matrix.row.end()}},
                                  {"column", {matrix.column.begin(), matrix.column.end()}},
                                  {"row_start", starts(matrix.row, matrix.rows)},
                                  {"column_start", starts(matrix.column, matrix.columns)},
                                  {"row_by_column", row_by_column},
                                  {"by_column", by_column}};
  for (IndexList &list : lists)
    for (std::size_t &index : list.values) index += base;
  return lists;
}

std::string storage_of(DerivativeMatrix const &matrix, bool is_full) {
  if (is_full) return "no element is zero by structure";
  if (!matrix.is_packed) return "all elements are stored, and those listed are not zero by structure";
  if (matrix.is_symmetric)
    return "those listed are stored, in this order; the matrix is symmetric, and nothing above its diagonal is listed";
  return "those listed are stored, in this order; the others are zero by structure";
}

} // namespace

std::vector<std::string> IndexList::texts() const {
  std::vector<std::string> result;
  for (std::size_t const value : values) result.push_back(std::to_string(value));
  return result;
}

std::string matrix_remark(Emission const &emission, MatrixText const &matrix) {
  std::vector<std::string> lines = {"The matrix " + matrix.name + ": " + matrix.storage + "."};
  if (!matrix.lists.empty())
    lines.insert(lines.end(),
                 {"Element k of those listed stands in row[k] and column[k]. Row i has those from row_start[i] up to",
                  "row_start[i + 1]. Column by column, column j has the places from column_start[j] up to",
                  "column_start[j + 1]: there are the rows in row_by_column, and in by_column the numbers k."});
  return comment(emission.language, lines, lines.size() > 1) + "\n";
}

std::vector<MatrixText> matrix_texts(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::vector<std::string> const names = identifiers(graph.outputs, emission.language.names);
  std::vector<MatrixText> texts;
  for (DerivativeMatrix const &matrix : graph.matrices) {
    bool const is_full = matrix.row.size() == std::size_t{matrix.rows} * matrix.columns;
    texts.push_back(
        {names[matrix.output], storage_of(matrix, is_full), matrix.rows, matrix.columns, matrix.row.size(), {}});
    if (!is_full) texts.back().lists = index_lists(matrix, emission.language.expressions.first_index);
  }
  return texts;
}

} // namespace symreal
