// Finds the decisions on REALs (if, ?:, loops) and collects how each becomes a select, or why it cannot.
#pragma once

#include "rewrite/pragma/pragma_handler.h"
#include "rewrite/select/arms.h"

namespace symreal::rewrite {

// Collector of the decisions of one function after another. Loops and the pragmas before statements are in loops.cpp.
class DecisionCollector {
public:
  DecisionCollector(clang::ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                    Facts &facts)
      : context_(context),
        map_(map),
        reals_(reals),
        index_(index),
        facts_(facts),
        conditions_(map, reals),
        analysis_(context, map, reals, conditions_) {}

  void function(clang::FunctionDecl const *function);
  // Reports the pragmas before statements that no function showed.
  void check_pragmas();
  // Refuses a `?:` of a macro that is also used where no select can stand.
  void check_use_of_macro(clang::ConditionalOperator const *choice);

private:
  // A decision under analysis.
  struct Site {
    Span key;
    clang::FileID frame;
    clang::SourceRange condition;
  };
  std::optional<Site> site(clang::SourceLocation token, clang::Expr const *condition);
  void refuse(Site const &site, Blocker const &blocker);
  void note(Site const &site, Blocker const &blocker, std::vector<Refusal> &refusals) const;
  void accept(Site const &site, std::vector<Alteration> alterations, std::optional<Span> needs = {});
  // The condition's characters, unless something stands against any select there.
  std::optional<Span> condition_span(Site const &site, Condition const &condition);
  // Replaces the characters from one token to another by `text`; the rest of their lines stays.
  std::optional<Alteration> replacing(clang::FileID frame, clang::SourceRange range, std::string text) const;

  void walk(clang::Stmt const *statement);
  void visit(clang::Stmt const *statement);
  void note_deciding(clang::Stmt const *statement);
  // `keyword` is invalid for an operand.
  void deciding(clang::SourceLocation keyword, clang::Expr const *value);
  void converting(clang::CastExpr const *cast);
  void deciding(clang::SourceLocation keyword, clang::SourceRange where, clang::Expr const *value, std::string type);
  void choose_statement(clang::IfStmt const *choice);
  void choose_value(clang::ConditionalOperator const *choice);
  bool select_value(clang::ConditionalOperator const *choice, bool becomes, bool yes, bool no);
  void make_plain(clang::Expr const *arm);
  void counted_arms(clang::ConditionalOperator const *choice);
  bool becomes_number(clang::ConditionalOperator const *choice) const;
  bool is_symbolic_integer(clang::Expr const *arm, bool becomes_number) const;
  bool is_lvalue_used(clang::ConditionalOperator const *choice) const;

  void free_loop(clang::Stmt const *loop, clang::Expr const *condition);
  void attach_pragmas(clang::Stmt const *statement);
  void attach_pragma(Span const &pragma, clang::SourceLocation place, clang::CompoundStmt const *block);
  void bound_loop(PragmaFact &pragma, clang::Stmt const *loop, clang::CompoundStmt const *block);
  std::set<clang::VarDecl const *> counters(clang::Stmt const *loop, clang::CompoundStmt const *block) const;
  std::optional<Span> empty_condition(clang::ForStmt const *loop) const;
  void report(DiagnosticId id, Place const &place, std::string message);

  // The function's `return`s as parts of selects, or the obstacle to that; computed once.
  struct Returns {
    std::optional<Blocker> blocker;
    Span brace;
  };
  Returns const &early_returns();
  std::optional<Blocker> collect_returns(std::vector<Alteration> &alterations, Span &brace) const;

  clang::ASTContext &context_;
  SourceMap const &map_;
  Reals const &reals_;
  PragmaIndex const &index_;
  Facts &facts_;
  Conditions conditions_;
  ArmAnalysis analysis_;

  clang::FunctionDecl const *function_ = nullptr;
  int lambdas_ = 0; // around the statement
  std::vector<clang::Stmt const *> parents_;
  std::optional<Returns> returns_;
  std::set<clang::Stmt const *> breaks_; // `if (...) break;` of bounded loops
  std::set<clang::ConditionalOperator const *> seen_;
  std::set<Span> attached_; // pragmas before statements
};

void collect_decisions(clang::ASTContext &context, SourceMap const &map, Reals const &reals, PragmaIndex const &index,
                       Facts &facts);

} // namespace symreal::rewrite
