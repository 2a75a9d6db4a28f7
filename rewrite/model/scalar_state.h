// Which scalars are state: objects that outlive a kernel and that the program could change, so that generated code
// bakes their values in. A scalar is what holds a value and is no REAL: an integer, a truth value, an enumerator, a
// float, a pointer to a function, and an object of a library such as text (symreal/numbers.h).
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

class ScalarState {
public:
  // Looks through the whole source for what is never changed.
  ScalarState(clang::ASTContext &context, SourceMap const &map);

  static bool is_integer(clang::QualType type);
  // A float or a long double.
  static bool is_floating(clang::QualType type);
  static bool is_function_pointer(clang::QualType type);
  static bool is_scalar(clang::QualType type) {
    return is_integer(type) || is_floating(type) || is_function_pointer(type);
  }
  // The objects of the class are scalars: std::string, std::variant.
  static bool has_value_of_its_own(clang::QualType type);
  static bool is_smart_pointer(clang::QualType type);
  // They are, and nothing else is known of what they hold.
  static bool is_opaque(clang::QualType type);

  // Can a class hold a value that goes from object to object? A stream and a lock cannot.
  static bool is_copied(clang::CXXRecordDecl const *record);
  // A class that is not rewritten, and that library.def does not describe, has a value of its own that only its
  // functions tell: a point in time, a type's index, an error code. An iterator says where something lies, which is
  // looked at there.
  bool is_unknown(clang::QualType type) const;

  // Does an object of this type hold a scalar in itself or in the elements of a container of the standard library?
  // An array of characters is data of another kind.
  bool holds(clang::QualType type) const;

  // No other source can name it, and this one changes it nowhere and hands its address to nobody.
  bool is_fixed(clang::VarDecl const *variable) const;

  // Can a reference be bound to it?
  static bool has_address(clang::Expr const *expression);
  static bool has_address(clang::FieldDecl const *field);

private:
  bool holds(clang::QualType type, llvm::SmallPtrSetImpl<clang::Type const *> &seen) const;

  SourceMap const &map_;
  llvm::SmallPtrSet<clang::CXXRecordDecl const *, 4> leaks_; // whose constructors tell others where their objects are
  llvm::DenseSet<clang::VarDecl const *> touched_;           // changed, or their addresses are used
};

} // namespace symreal::rewrite
