// Arguments that are apart in the recorded call, and that another call may give in one place: the original then writes
// what it has yet to read. A wrapper compares how they lie.
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
  clang::ValueDecl const *root = nullptr; // what the first name of the base refers to
  std::string root_name = {};
};

// Pairs of which one is an output. What no call can bring together is left out: parameters that are passed by value,
// two variables, two members of one object, what a restricted pointer leads to.
std::vector<Overlap> possible_overlaps(clang::FunctionDecl const *function, std::vector<PlacedItem> const &items);

} // namespace symreal::rewrite
