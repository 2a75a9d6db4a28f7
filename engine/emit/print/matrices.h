// Where the elements of matrices of derivatives stand that are stored, or not zero by structure: as coordinates, and by
// rows (CSR) and by columns (CSC) compressed.
#pragma once

#include "engine/emit/print/emission.h"

namespace symreal {

struct IndexList {
  std::string_view name;
  std::vector<std::size_t> values; // from the language's first index on

  std::vector<std::string> texts() const;
};

struct MatrixText {
  std::string name;    // of the output
  std::string storage; // in words
  std::size_t rows, columns, nonzeros;
  std::vector<IndexList> lists; // none: every element is stored in its place

  std::vector<std::pair<std::string, std::size_t>> sizes() const {
    return {{"rows", rows}, {"columns", columns}, {"nonzeros", nonzeros}};
  }
};

std::vector<MatrixText> matrix_texts(Emission const &emission);
// A comment that says what is stored, and what the lists are.
std::string matrix_remark(Emission const &emission, MatrixText const &matrix);

} // namespace symreal
