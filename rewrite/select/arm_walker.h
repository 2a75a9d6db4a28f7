// Walk of ArmAnalysis: statements in arm_walker.cpp, expressions in arm_expressions.cpp, assigned targets in
// arm_targets.cpp. The first obstacle ends it.
#pragma once

#include "rewrite/select/arms.h"

namespace symreal::rewrite {

class ArmWalker {
public:
  enum class Scope { arm, body };

  // `function`: whose body is walked, if it is one.
  ArmWalker(ArmAnalysis &analysis, Scope scope, Allowed const &allowed, clang::FunctionDecl const *function = nullptr)
      : analysis_(analysis),
        scope_(scope),
        allowed_(allowed),
        function_(function),
        loops_(allowed.in_loop ? 1 : 0) {}

  // `is_last`: nothing of its arm comes after the statement.
  void statement(clang::Stmt const *statement, bool is_last);
  void expression(clang::Expr const *expression);
  void own(clang::VarDecl const *variable) { own_.insert(variable); }
  void construction(clang::CXXConstructExpr const *construction);

  Arms result;

private:
  bool blocked() const { return result.blocker.has_value(); }
  void block(clang::SourceLocation location, Reason reason);

  void declaration(clang::DeclStmt const *statement);
  void variable(clang::VarDecl const *variable);
  void loop(clang::Stmt const *loop, clang::Expr const *condition, clang::Stmt const *body);
  void choice(clang::IfStmt const *choice, bool is_last);
  void jump(clang::Stmt const *jump, Reason reason);

  void call(clang::CallExpr const *call);
  bool library_call(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void math_call(clang::CallExpr const *call);
  void binary(clang::BinaryOperator const *binary);

  void assignment(clang::Expr const *target);
  // The variable in which the object lies, if no pointer or reference leads there.
  clang::VarDecl const *home(clang::Expr const *object) const;
  bool is_own(clang::Expr const *object) const;
  bool mentions_own(clang::Expr const *expression) const;
  bool index_is_fixed(clang::Expr const *target);
  // The part of an element's expression before the first index that is a variable of the arm.
  clang::Expr const *without_own_indices(clang::Expr const *target) const;
  void add_target(clang::Expr const *target);
  std::string words(clang::Expr const *expression) const;

  ArmAnalysis &analysis_;
  Scope const scope_;
  Allowed const &allowed_;
  clang::FunctionDecl const *function_;
  std::set<clang::VarDecl const *> own_;
  int loops_; // around the statement, without a decision on REALs in between
};

} // namespace symreal::rewrite
