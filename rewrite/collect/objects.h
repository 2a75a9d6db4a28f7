// Base of the handlers that note uses of objects: a kernel bakes in what outlives it, and the recording judges by
// addresses whether an object does.
#pragma once

#include "rewrite/collect/handler.h"
#include "rewrite/model/storage.h"

namespace symreal::rewrite {

class ObjectUses : public SyntaxHandler {
public:
  explicit ObjectUses(SyntaxTable &table)
      : SyntaxHandler(table),
        scalars_(all_.scalars),
        surroundings_(all_.surroundings),
        storage_(all_.reals) {}

protected:
  // Wraps the expression in a macro that reports its name and place. `named`: the expression that supplies these, if it
  // is another one. `words`: further arguments of the macro, before them.
  void note(clang::Expr const *expression, Use use, clang::Expr const *named = nullptr, std::string const &words = "");
  // On one line, and cut off where it is long.
  std::string short_text(Span const &span, clang::SourceLocation at) const;

  bool may_outlive(clang::Expr const *expression) const;
  bool is_fixed(clang::Expr const *expression) const;
  bool holds_state(clang::QualType type) const { return reals_.carries_real(type) || scalars_.holds(type); }
  bool is_value(clang::QualType type) const;

  void scalar(clang::Expr const *expression, Use use);
  // A pointer gets a new value.
  void pointer(clang::Expr const *expression);
  void object(clang::Expr const *expression, Use use);
  void changed_value(clang::Expr const *expression);
  void leads(clang::Expr const *expression);
  void decides(clang::Expr const *expression);
  void decides_by_pointer(clang::Expr const *object);

  // Bytes of numbers (bits.cpp). `looked_into`: adds a run-time check for symbolic ones.
  void looked_into(clang::Expr const *address);
  void given_bytes(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument);
  bool moved_bytes(clang::CallExpr const *call, clang::FunctionDecl const *function);

  ScalarState const &scalars_;
  Surroundings const &surroundings_;
  Storage const storage_;

private:
  bool is_lasting_array(clang::Expr const *expression) const;
};

// Base of the handlers of objects whose values are used.
class Loads : public ObjectUses {
public:
  explicit Loads(SyntaxTable &table) : ObjectUses(table) {
    on<clang::ImplicitCastExpr>(RUNNING, &Loads::loaded);
    on<clang::InitListExpr>(RUNNING, &Loads::elements);
  }

protected:
  virtual void read(clang::Expr const *object) = 0;

private:
  void loaded(clang::ImplicitCastExpr const *cast);
  void elements(clang::InitListExpr const *list);
  void load(clang::Expr const *value);
};

} // namespace symreal::rewrite
