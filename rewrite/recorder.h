// What the visitor tells about one kind of syntax each. Every member records facts and edits nothing.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/facts.h"
#include "rewrite/reals.h"
#include "rewrite/source_map.h"

namespace symreal::rewrite {

class Recorder {
public:
  Recorder(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts)
      : context_(context),
        map_(map),
        reals_(reals),
        facts_(facts) {}

  // Types (record_types.cpp).
  void builtin_type(clang::BuiltinTypeLoc type, bool passive);
  void complex_type(clang::ComplexTypeLoc type);
  // A name outside the roots for a type with double in it: Eigen's Vector3d, double_t.
  void typedef_name(clang::TypedefNameDecl const *declaration, clang::SourceLocation name, bool qualified,
                    bool within_type);

  // Calls (record_calls.cpp).
  void call(clang::CallExpr const *call);
  void symbolic_main(clang::CallExpr const *call, clang::FunctionDecl const *function);
  void construction(clang::CXXConstructExpr const *construction);
  void variadic_definition(clang::FunctionDecl const *function);
  void converting_construction(clang::CXXConstructExpr const *construction);

  // Everything else (record_expressions.cpp).
  void implicit_cast(clang::ImplicitCastExpr const *cast, bool decides);
  void explicit_cast(clang::ExplicitCastExpr const *cast);
  void compound_assignment(clang::CompoundAssignOperator const *assignment);
  void choice(clang::ConditionalOperator const *choice);
  void deduced_variable(clang::VarDecl const *variable);
  void deduced_return(clang::Stmt const *body);
  void deduced_elements(clang::Expr const *initializer);
  void state(clang::VarDecl const *variable, clang::Expr const *reference);
  void c_declaration(clang::NamedDecl const *declaration);

  // What numbers are called (record_names.cpp).
  void named_variable(clang::VarDecl const *variable);
  void named_target(clang::BinaryOperator const *assignment);

private:
  void name(llvm::StringRef name, clang::SourceLocation begin, clang::SourceLocation end);

  using Arguments = llvm::ArrayRef<clang::Expr const *>;
  void arguments(clang::FunctionDecl const *function, Arguments arguments, bool overloaded);
  void literal_argument(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument,
                        bool overloaded, unsigned count);
  void outside_argument(clang::FunctionDecl const *function, unsigned index, clang::Expr const *argument);
  bool takes_only(clang::FunctionDecl const *function) const;

  void wrap(clang::Expr const *expression, Use use, std::string detail = {});
  void report(DiagnosticId id, clang::SourceLocation location, std::string message,
              Severity severity = Severity::error);
  // The literal of an initializer or argument: double, and double in the symbolic program too.
  bool is_plain_double(clang::Expr const *expression) const;

  clang::ASTContext &context_;
  SourceMap const &map_;
  Reals const &reals_;
  Facts &facts_;
};

} // namespace symreal::rewrite
