// Index lists of the stored or structurally nonzero elements of derivative matrices: as coordinates, and compressed by
// rows (CSR) and by columns (CSC).
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

struct IndexList {
  std::string_view name;
  std::vector<std::size_t> values; // counted from the language's first index

  std::vector<std::string> texts() const;
};

struct MatrixText {
  std::string name;    // of the output
  std::string storage; // description
  std::size_t rows, columns, nonzeros;
  std::vector<IndexList> lists; // empty: every element is stored in its place

  std::vector<std::pair<std::string, std::size_t>> sizes() const {
    return {{"rows", rows}, {"columns", columns}, {"nonzeros", nonzeros}};
  }
};

std::vector<MatrixText> matrix_texts(Emission const &emission);
// Comment that describes the stored elements and the lists.
std::string matrix_remark(Emission const &emission, MatrixText const &matrix);

} // namespace symreal
