// Which integers are state: objects that outlive a kernel and that the program could change, so that generated code
// bakes their values in. Truth values and enumerators are integers here.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

namespace symreal::rewrite {

class IntegerState {
public:
  // Looks through the whole source for what is never changed.
  IntegerState(clang::ASTContext &context, SourceMap const &map);

  static bool is_integer(clang::QualType type);

  // Does an object of this type hold an integer in itself or in the elements of a container of the standard library?
  // Text is data of another kind.
  bool holds(clang::QualType type) const;

  // No other source can name it, and this one changes it nowhere and hands its address to nobody.
  bool is_fixed(clang::VarDecl const *variable) const;

  // Can a reference be bound to it?
  static bool has_address(clang::Expr const *expression);
  static bool has_address(clang::FieldDecl const *field);

private:
  bool holds(clang::QualType type, llvm::SmallPtrSetImpl<clang::Type const *> &seen) const;

  SourceMap const &map_;
  llvm::DenseSet<clang::VarDecl const *> touched_; // changed, or their addresses are used
};

} // namespace symreal::rewrite
