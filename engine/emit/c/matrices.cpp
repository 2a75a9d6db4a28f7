#include "engine/emit/print/matrices.h"
#include "engine/emit/c/parts.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

std::string name_of(Emission const &emission, MatrixText const &matrix, IndexList const &list) {
  return emission.name(matrix.name + "_" + std::string(list.name));
}

// C lacks arrays without elements.
std::size_t length_of(IndexList const &list) { return std::max<std::size_t>(list.values.size(), 1); }

std::string definition(Emission const &emission, MatrixText const &matrix, IndexList const &list) {
  std::string const values = list.values.empty() ? " 0 " : lines_of(emission.language, list.texts());
  return fmt::format("int const {}[{}] = {{{}}};\n", name_of(emission, matrix, list), length_of(list), values);
}

std::string sizes(Emission const &emission, MatrixText const &matrix) {
  std::string text;
  for (auto const &[name, value] : matrix.sizes())
    text += fmt::format("{} {} = {}", text.empty() ? "" : ",", emission.name(matrix.name + "_" + name), value);
  return "enum {" + text + " };\n";
}

} // namespace

std::string c_matrices(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += matrix_remark(emission, matrix) + sizes(emission, matrix);
    for (IndexList const &list : matrix.lists)
      text += fmt::format("extern int const {}[{}];\n", name_of(emission, matrix, list), length_of(list));
    text += "\n";
  }
  return text;
}

std::string c_matrix_lists(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission))
    for (IndexList const &list : matrix.lists) text += "\n" + definition(emission, matrix, list);
  return text;
}

std::string cpp_matrices(Emission const &emission) {
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += matrix_remark(emission, matrix) + sizes(emission, matrix);
    for (IndexList const &list : matrix.lists) text += "inline constexpr " + definition(emission, matrix, list);
    text += "\n";
  }
  return text;
}

std::string c_end(Emission const &emission) { return c_matrix_lists(emission) + c_guard_text(emission); }

} // namespace symreal
