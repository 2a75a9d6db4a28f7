// Interface of a kernel's function for other files that call it, declare it under another name or define it in its
// place.
#pragma once

#include "rewrite/facts/result.h"
#include "rewrite/source/clang.h"

#include <optional>
#include <string>
#include <vector>

namespace symreal::rewrite {

// The type as text that is valid in any scope.
std::string type_text(clang::QualType type, clang::ASTContext const &context);
// Declaration of the name with this type: double (*name)(double), double name[3]. Types have all their scopes.
std::string declared(clang::QualType type, std::string name, clang::ASTContext const &context);

// Declaration of a function from the syntax tree, without default arguments, and the arguments that pass its parameters
// on. Parameters without a name have one here. Nullopt unless it can be declared under another name: for a member, a
// template, a function in a namespace, one with variable arguments or other functions of its name.
std::optional<Signature> plain_declaration(clang::FunctionDecl const *function, clang::LangOptions const &language);

// A name in the items of a kernel, and its declaration.
struct NamedItem {
  std::string name;
  clang::ValueDecl const *declaration;
};

// Redefinition of a function in another file: the includes, declarations and scopes that it needs.
Redefinition redefinition(clang::FunctionDecl const *function, std::vector<NamedItem> const &names);

// An item of a kernel's clauses that names numbers.
struct PlacedItem {
  std::string label, base; // the base: without its sections
  std::size_t sections = 0;
  bool is_output = false;
  clang::QualType base_type = {};
  clang::ValueDecl const *root = nullptr; // the declaration of the base's first name
  std::string root_name = {};
};

// Arguments that are apart in the recorded call, and that may alias in another: the original then overwrites values
// before it reads them. A wrapper compares their addresses. Pairs with at least one output; those that cannot alias are
// left out: parameters passed by value, two variables, two members of one object, targets of a restrict pointer.
std::vector<Overlap> possible_overlaps(clang::FunctionDecl const *function, std::vector<PlacedItem> const &items);

// An item of a kernel's clauses.
struct BakedItem {
  std::string label, expression;
  std::vector<Section> sections;
  Place place;
  clang::QualType type;     // of each element
  bool is_constant = false; // else an input, a parameter or an output
};

// Values that a recording bakes in, with their access paths for a wrapper of another call: arguments, items of
// `constant`, the non-numeric members of annotated objects, and the classes of objects whose virtual functions the
// kernel calls (baked_values.cpp).
//
//   shape  := { "[" count "]" } what
//   what   := "d"                          a floating-point number
//           | "i"                          an integer, truth value or enumerator
//           | "b"                          the same in a bit-field
//           | "p"                          a pointer: whether it is null
//           | "l"                          a long double
//           | "c"                          a comparison of two pointers
//           | "o"                          how two items lie that may overlap (possible_overlaps)
//           | "s"                          text that a null character ends
//           | "f"                          what is called through it: a pointer to a function, std::function
//           | "t"                          an object of a class with virtual functions: its class
//           | "x"                          an integer that the function may not name
//           | "@"                          in C++: a container, or what a template has there
//           | "z"                          a container of numbers, whose extents alone are baked in
//           | "{" { member ":" shape ";" } "}"
//           | "?" reason                   it cannot be compared
//   member := name
std::vector<Baked> baked_values(clang::FunctionDecl const *function, std::vector<BakedItem> const &items,
                                Place const &place);

} // namespace symreal::rewrite
