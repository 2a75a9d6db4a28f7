// The text of a file around its functions: interface names, sizes, objects, matrices, recorded values. The parts of
// languages with patterns for them (ModuleSyntax).
#pragma once

#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// Interface names and sizes for the patterns.
Filling interface_names(Emission const &emission);

// Sizes, object offsets, structures of objects, remarks.
std::string module_begin(Emission const &emission);
// Texts of the guards, and the end of the file.
std::string module_end(Emission const &emission);
std::string module_main(Emission const &emission);

// Values for the patterns of a main program, except $call.
Filling module_facts(Emission const &emission);

// Index lists of the stored or structurally nonzero elements of derivative matrices: as coordinates, and compressed by
// rows (CSR) and by columns (CSC).
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

// Name of each output, in order: "y[0]", "m[1][0]".
std::vector<std::string> output_names(Emission const &emission);

// Each number as a literal of the language.
std::vector<std::string> constants(Language const &language, std::vector<double> const &values);

} // namespace symreal
