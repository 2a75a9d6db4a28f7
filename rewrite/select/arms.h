// Analysis of a decision's arms: whether both may be executed, and which targets they assign.
//
// An arm may compute, assign REALs, and do anything with variables of its own. Any other visible effect (an integer
// that is assigned, a jump, output, memory) blocks it.
#pragma once

#include "rewrite/model/conditions.h"

#include <map>
#include <set>

namespace symreal::rewrite {

struct Arms {
  std::optional<Blocker> blocker;
  std::vector<std::string> targets; // assigned lvalues, as the source spells them, each once
  bool returns = false;             // an arm ends in `return`
};

// Further effects that the statements may have, besides computing and assigning REALs.
struct Allowed {
  clang::FileID frame;                            // file or macro of the decision: its targets are spelled there
  bool returns = false;                           // as the last statement of an arm
  bool in_loop = false;                           // they are a loop's body
  std::set<clang::Stmt const *> breaks = {};      // `if (...) break;` statements that are handled
  std::set<clang::VarDecl const *> counters = {}; // integers that may be assigned: they are dead afterwards
};

class ArmAnalysis {
public:
  ArmAnalysis(clang::ASTContext const &context, SourceMap const &map, Reals const &reals, Conditions const &conditions)
      : context_(context),
        map_(map),
        reals_(reals),
        conditions_(conditions) {}

  Arms arms(std::vector<clang::Stmt const *> const &statements, Allowed const &allowed = {});

  // Whether the body may be executed without visible effects other than the returned value. With `after_returns`, only
  // the part after its first `return` on a condition of REALs counts.
  enum class BodyPart { whole, after_returns };
  std::optional<Blocker> body(clang::FunctionDecl const *function, BodyPart part = BodyPart::whole);

  // Loops on REALs that a pragma bounds.
  std::set<clang::Stmt const *> bounded_loops;

private:
  friend class ArmWalker;
  // Reason why a call of the function blocks; nullopt if it does not.
  std::optional<Reason> call_of(clang::FunctionDecl const *function);

  clang::ASTContext const &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Conditions const &conditions_;
  std::map<clang::FunctionDecl const *, std::optional<Reason>> known_;
};

// Walk of ArmAnalysis, which the first obstacle ends. Assigned targets are in arm_targets.cpp.
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

  Arms result;

private:
  bool blocked() const { return result.blocker.has_value(); }
  void block(clang::SourceLocation location, Reason reason);

  void declaration(clang::DeclStmt const *statement);
  void variable(clang::VarDecl const *variable);
  void loop(clang::Stmt const *loop, clang::Expr const *condition, clang::Stmt const *body);
  void choice(clang::IfStmt const *choice, bool is_last);
  void jump(clang::Stmt const *jump, Reason reason);

  void construction(clang::CXXConstructExpr const *construction);
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
