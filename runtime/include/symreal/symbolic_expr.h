// Symbolic expressions seen from a program: what a RealNumber stands for, and the pool that owns all of them.
#pragma once

#include <symreal/real_number.h>

#include <cstddef>
#include <iosfwd>

namespace symreal {

enum class SymbolicKind { constant, parametric_constant, variable };

// A view of one expression; valid while its kernel is being recorded.
class SymbolicExpr {
public:
  SymbolicExpr(RealNumber number) noexcept : number_(number) {}

  // An expression of constants is constant, of constants and parameters parametric, with any variable variable.
  SymbolicKind kind() const noexcept;
  bool is_constant() const noexcept { return kind() == SymbolicKind::constant; }
  bool is_parametric() const noexcept { return kind() == SymbolicKind::parametric_constant; }
  bool is_variable() const noexcept { return kind() == SymbolicKind::variable; }
  // A change of sign, or a negative constant.
  bool is_negative() const noexcept;

  // "q", "m[2]", "sin", "10": the annotation's label, the operation or the number.
  std::string name() const;
  // The expression in C's notation, cut off where it gets long.
  void print(std::ostream &out) const;

  RealNumber number() const noexcept { return number_; }

private:
  RealNumber number_;
};

std::ostream &operator<<(std::ostream &out, SymbolicExpr const &expression);

// The pool of the calling thread. No computation exists in it twice.
class SymbolicExprPool {
public:
  // The expression with this operation and these operands, new or old.
  static SymbolicExpr get_symbolic_expr(Op op, RealNumber x, RealNumber y = 0.0, RealNumber z = 0.0) noexcept {
    return detail::record(op, x, y, z);
  }
  // How many nodes the current recording has.
  static std::size_t size() noexcept;
};

} // namespace symreal
