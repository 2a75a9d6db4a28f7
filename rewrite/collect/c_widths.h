// Widths in which gcc's C computes: with a bit-field wider than int in a type of just as many bits, so that `f.b << 1`
// loses the bits that do not fit. C++ uses the bit-field's declared type, as Clang does in both languages.
#pragma once

#include "rewrite/source/clang.h"

namespace symreal::rewrite {

struct Width {
  unsigned bits = 0; // of an integer; 0 for other types
  bool is_signed = true;
  bool is_narrow() const { return bits > 32 && bits != 64 && bits != 128; }
};

// The usual arithmetic conversions, on types of any width.
Width common(Width one, Width other);

class Widths {
public:
  explicit Widths(clang::ASTContext &context) : context_(context) {}
  Width of(clang::Expr const *expression);

private:
  Width computed(clang::Expr const *expression);

  clang::ASTContext &context_;
  llvm::DenseMap<clang::Expr const *, Width> known_;
};

} // namespace symreal::rewrite
