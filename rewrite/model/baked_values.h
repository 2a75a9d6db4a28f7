// Values that a recording bakes in, with their access paths for a wrapper of another call.
//
//   shape  := { "[" count "]" } what
//   what   := "d"                          a floating-point number
//           | "i"                          an integer, truth value or enumerator
//           | "b"                          the same in a bit-field
//           | "p"                          a pointer: whether it is null
//           | "l"                          a long double
//           | "c"                          a comparison of two pointers
//           | "o"                          how two items lie that may overlap (rewrite/model/overlaps.h)
//           | "s"                          text that a null character ends
//           | "f"                          what is called through it: a pointer to a function, std::function
//           | "t"                          an object of a class with virtual functions: its class
//           | "x"                          an integer that the function may not name
//           | "@"                          in C++: a container, or what a template has there
//           | "z"                          a container of numbers, whose extents alone are baked in
//           | "{" { member ":" shape ";" } "}"
//           | "?" reason                   it cannot be compared
//   member := name
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// An item of a kernel's clauses.
struct BakedItem {
  std::string label, expression;
  std::vector<Section> sections;
  Place place;
  clang::QualType type;     // of each element
  bool is_constant = false; // else an input, a parameter or an output
};

// Arguments, items of `constant`, the non-numeric members of annotated objects, and the classes of objects whose
// virtual functions the kernel calls.
std::vector<Baked> baked_values(clang::FunctionDecl const *function, std::vector<BakedItem> const &items,
                                Place const &place);

ReturnedObject returned_object(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
