// Arguments that are apart in the recorded call, and that may alias in another: the original then overwrites values
// before it reads them. A wrapper compares their addresses.
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// An item of a kernel's clauses that names numbers.
struct PlacedItem {
  std::string label, base; // the base: without its sections
  std::size_t sections = 0;
  bool is_output = false;
  clang::QualType base_type = {};
  clang::ValueDecl const *root = nullptr; // the declaration of the base's first name
  std::string root_name = {};
};

// Pairs with at least one output. Pairs that cannot alias are left out: parameters passed by value, two variables, two
// members of one object, targets of a restrict pointer.
std::vector<Overlap> possible_overlaps(clang::FunctionDecl const *function, std::vector<PlacedItem> const &items);

} // namespace symreal::rewrite
