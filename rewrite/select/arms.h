// What the arms of a decision do: may both be executed, and what do they assign?
//
// An arm may compute, assign REALs, and do what it likes with variables of its own. Whatever else would show outside
// (an integer that is assigned, a jump, output, memory) blocks it.
#pragma once

#include "rewrite/model/conditions.h"

#include <map>
#include <set>

namespace symreal::rewrite {

struct Arms {
  std::optional<Blocker> blocker;
  std::vector<std::string> targets; // what is assigned, as the source spells it, each once
  bool returns = false;             // an arm ends in `return`
};

// What else than computing and assigning the statements may do.
struct Allowed {
  clang::FileID frame;                            // where the decision is written: its targets are spelled there
  bool returns = false;                           // as the last statement of an arm
  bool in_loop = false;                           // they are a loop's body
  std::set<clang::Stmt const *> breaks = {};      // these `if (...) break;` are dealt with
  std::set<clang::VarDecl const *> counters = {}; // integers that may be assigned: nobody reads them afterwards
};

class ArmAnalysis {
public:
  ArmAnalysis(clang::ASTContext const &context, SourceMap const &map, Reals const &reals, Conditions const &conditions)
      : context_(context),
        map_(map),
        reals_(reals),
        conditions_(conditions) {}

  Arms arms(std::vector<clang::Stmt const *> const &statements, Allowed const &allowed = {});

  // May the whole body be executed without anything to show but the returned value?
  // Only what comes after its first `return` on a condition of REALs counts if `after_returns`.
  enum class Part { whole, after_returns };
  std::optional<Blocker> body(clang::FunctionDecl const *function, Part part = Part::whole);

  // Loops on REALs that a pragma bounds.
  std::set<clang::Stmt const *> bounded_loops;

private:
  friend class ArmWalker;
  // Why a call of the function blocks; nothing if it does not.
  std::optional<Reason> call_of(clang::FunctionDecl const *function);

  clang::ASTContext const &context() const { return context_; }

  clang::ASTContext const &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Conditions const &conditions_;
  std::map<clang::FunctionDecl const *, std::optional<Reason>> known_;
};

// Does the type consist of REALs alone, in memory of its own?
bool only_reals(clang::QualType type, Reals const &reals);

} // namespace symreal::rewrite
