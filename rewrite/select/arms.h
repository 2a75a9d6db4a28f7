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
  enum class Part { whole, after_returns };
  std::optional<Blocker> body(clang::FunctionDecl const *function, Part part = Part::whole);

  // Loops on REALs that a pragma bounds.
  std::set<clang::Stmt const *> bounded_loops;

private:
  friend class ArmWalker;
  // Reason why a call of the function blocks; nullopt if it does not.
  std::optional<Reason> call_of(clang::FunctionDecl const *function);

  clang::ASTContext const &context() const { return context_; }

  clang::ASTContext const &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Conditions const &conditions_;
  std::map<clang::FunctionDecl const *, std::optional<Reason>> known_;
};

// Whether the type consists of REALs alone, in memory of its own.
bool only_reals(clang::QualType type, Reals const &reals);

} // namespace symreal::rewrite
