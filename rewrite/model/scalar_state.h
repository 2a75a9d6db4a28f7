// Scalars that are state: objects that outlive a kernel and that the program could change, so that generated code bakes
// their values in. A scalar holds a value that is not REAL: an integer, a truth value, an enumerator, a float, a
// pointer to a function, or an object of a library such as text (symreal/numbers.h).
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

class ScalarState {
public:
  // Scans the whole source for variables that are never changed.
  ScalarState(clang::ASTContext &context, SourceMap const &map);

  static bool is_integer(clang::QualType type);
  // Whether the type is float or long double.
  static bool is_floating(clang::QualType type);
  static bool is_function_pointer(clang::QualType type);
  static bool is_scalar(clang::QualType type) {
    return is_integer(type) || is_floating(type) || is_function_pointer(type);
  }
  // Whether the objects of the class are scalars: std::string, std::variant.
  static bool has_value_of_its_own(clang::QualType type);
  static bool is_smart_pointer(clang::QualType type);
  // Whether they are scalars whose contents are unknown.
  static bool is_opaque(clang::QualType type);

  // Whether a value of the class can be copied from object to object. A stream and a lock cannot.
  static bool is_copied(clang::CXXRecordDecl const *record);
  // A class that is not rewritten, and that library.def does not describe, has a value of its own that only its
  // functions reveal: a point in time, a type's index, an error code. Not an iterator: its position is checked where it
  // is used.
  bool is_unknown(clang::QualType type) const;

  // Whether an object of this type holds a scalar in itself or in the elements of a container of the standard library.
  // Arrays of characters do not count.
  bool holds(clang::QualType type) const;

  // Whether the variable has internal linkage, is never changed in this source, and its address does not escape.
  bool is_fixed(clang::VarDecl const *variable) const;

  // Whether a reference can be bound to it.
  static bool has_address(clang::Expr const *expression);
  static bool has_address(clang::FieldDecl const *field);

private:
  bool holds(clang::QualType type, llvm::SmallPtrSetImpl<clang::Type const *> &seen) const;

  SourceMap const &map_;
  llvm::SmallPtrSet<clang::CXXRecordDecl const *, 4>
      leaks_;                                      // classes whose constructors let the object's address escape
  llvm::DenseSet<clang::VarDecl const *> touched_; // changed, or with an escaping address
};

} // namespace symreal::rewrite
