// Analysis of conditions on REALs: which can stay symbolic as a whole, so that a select can take them.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"

#include <optional>
#include <vector>

namespace symreal::rewrite {

// An obstacle to a select, at its token.
struct Blocker {
  clang::SourceLocation location;
  Reason reason;
};

// Comparisons of REALs, joined by &&, || and !, possibly with plain truth values.
struct Condition {
  bool is_real = false;           // it depends on a comparison of REALs, or on a REAL's truth value
  std::optional<Blocker> blocker; // it is decided before the statement sees it
  std::vector<Alteration> joints; // && and || become REAL_AND and REAL_OR, beside which plain ones need REAL_PLAIN
};

class Conditions {
public:
  Conditions(SourceMap const &map, Reals const &reals) : map_(map), reals_(reals) {}

  Condition classify(clang::Expr const *condition) const;

  // Whether a comparison of REALs stands anywhere in the expression, lambdas aside.
  bool mentions_comparison(clang::Expr const *expression) const;

  // Whether any part of the expression becomes a REAL.
  bool mentions_real(clang::Expr const *expression) const;

private:
  enum class Kind { plain, mixed, real, truth_of_real };
  Kind visit(clang::Expr const *expression, Condition &result) const;
  Kind visit_joint(clang::BinaryOperator const *joint, Condition &result) const;

  SourceMap const &map_;
  Reals const &reals_;
};

} // namespace symreal::rewrite
