// Walk of the syntax tree within the roots that tracks the context of each part.
#pragma once

#include "rewrite/model/library.h"
#include "rewrite/model/reals.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"
#include "rewrite/source/walk.h"

#include <utility>

namespace symreal::rewrite {

class ContextWalk : public Walk {
public:
  ContextWalk(SourceMap const &map, Reals const &reals) : map_(map), reals_(reals) {}

  bool TraverseDecl(clang::Decl *declaration) override {
    if (!declaration) return true;
    if (!clang::isa<clang::TranslationUnitDecl>(declaration) && declaration->getLexicalDeclContext()->isFileContext() &&
        !map_.in_roots(declaration->getLocation()) && !map_.in_roots(declaration->getBeginLoc()))
      return true;
    auto const *function = clang::dyn_cast<clang::FunctionDecl>(declaration);
    if (!function) return Walk::TraverseDecl(declaration);
    Within const dependent(in_template_, function->isDependentContext());
    Within const allocates(no_state_, is_allocation(function)); // an allocator's own data is not a kernel's state
    clang::FunctionDecl const *const outer = std::exchange(function_, function);
    bool const more = Walk::TraverseDecl(declaration);
    function_ = outer;
    return more;
  }

  bool TraverseLambdaExpr(clang::LambdaExpr *lambda) override {
    Within const generic(in_template_, lambda->isGenericLambda());
    clang::FunctionDecl const *const outer = std::exchange(function_, lambda->getCallOperator());
    bool const more = Walk::TraverseLambdaExpr(lambda);
    function_ = outer;
    return more;
  }

  // A capture without an initializer has no expression that could be wrapped.
  bool TraverseLambdaCapture(clang::LambdaExpr *lambda, clang::LambdaCapture const *capture,
                             clang::Expr *initializer) override {
    return !lambda->isInitCapture(capture) || Walk::TraverseLambdaCapture(lambda, capture, initializer);
  }

  // A using-declaration of a base's constructors: their name does not spell a type, and the type before it is walked.
  bool TraverseUsingDecl(clang::UsingDecl *declaration) override {
    if (declaration->getDeclName().getNameKind() == clang::DeclarationName::CXXConstructorName)
      return this->TraverseNestedNameSpecifierLoc(declaration->getQualifierLoc());
    return Walk::TraverseUsingDecl(declaration);
  }
  bool TraverseUnresolvedUsingValueDecl(clang::UnresolvedUsingValueDecl *declaration) override {
    if (declaration->getDeclName().getNameKind() == clang::DeclarationName::CXXConstructorName)
      return this->TraverseNestedNameSpecifierLoc(declaration->getQualifierLoc());
    return Walk::TraverseUnresolvedUsingValueDecl(declaration);
  }

  // Variables that stay double.
  bool TraverseVarDecl(clang::VarDecl *variable) override {
    Passive const why = variable->isConstexpr()       ? constant_variable
                        : reals_.is_passive(variable) ? static_member
                                                      : not_passive;
    Within const passive(passive_, why);
    Within const constant(no_state_, variable->isFileVarDecl() || variable->isStaticDataMember());
    return Walk::TraverseVarDecl(variable);
  }
  bool TraverseFunctionDecl(clang::FunctionDecl *function) override {
    Within const passive(passive_, reals_.external(function) ? external_declaration : not_passive);
    return Walk::TraverseFunctionDecl(function);
  }
  bool TraverseNonTypeTemplateParmDecl(clang::NonTypeTemplateParmDecl *parameter) override {
    Within const passive(passive_, template_value);
    return Walk::TraverseNonTypeTemplateParmDecl(parameter);
  }
  bool TraverseStaticAssertDecl(clang::StaticAssertDecl *assertion) override {
    Within const passive(passive_, static_assertion);
    return Walk::TraverseStaticAssertDecl(assertion);
  }
  bool TraverseEnumConstantDecl(clang::EnumConstantDecl *constant) override {
    Within const passive(passive_, enumerator);
    return Walk::TraverseEnumConstantDecl(constant);
  }
  bool TraverseConstantExpr(clang::ConstantExpr *constant) override {
    Within const passive(passive_, constant_expression);
    return Walk::TraverseConstantExpr(constant);
  }
  bool TraverseConstantArrayTypeLoc(clang::ConstantArrayTypeLoc type) override {
    if (!this->TraverseTypeLoc(type.getElementLoc())) return false;
    Within const passive(passive_, array_bound);
    return this->TraverseStmt(type.getSizeExpr());
  }
  bool TraverseTemplateArgumentLoc(clang::TemplateArgumentLoc const &argument) override {
    Within const value(is_template_value_, argument.getArgument().getKind() == clang::TemplateArgument::Expression);
    return Walk::TraverseTemplateArgumentLoc(argument);
  }
  bool TraverseTemplateSpecializationTypeLoc(clang::TemplateSpecializationTypeLoc type) override {
    clang::TemplateDecl const *declaration = type.getTypePtr()->getTemplateName().getAsTemplateDecl();
    Within const passive(passive_, Reals::is_passive_template(declaration) ? plain_template : not_passive);
    return Walk::TraverseTemplateSpecializationTypeLoc(type);
  }

  // Operands that are not evaluated: their types count, their values do not.
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr *expression) override {
    Within const unevaluated(no_state_, true);
    return Walk::TraverseUnaryExprOrTypeTraitExpr(expression);
  }
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr *expression) override {
    Within const unevaluated(no_state_, true);
    return Walk::TraverseCXXNoexceptExpr(expression);
  }
  bool TraverseCXXTypeidExpr(clang::CXXTypeidExpr *expression) override {
    bool const is_evaluated = !expression->isTypeOperand() && !expression->isTypeDependent() &&
                              !expression->getExprOperand()->isTypeDependent() && expression->isPotentiallyEvaluated();
    Within const unevaluated(no_state_, !is_evaluated);
    return Walk::TraverseCXXTypeidExpr(expression);
  }

protected:
  // A flag that holds for the part of the tree below; the outermost says why.
  template <class Flag> class Within {
  public:
    Within(Flag &flag, Flag value) : flag_(flag), before_(flag) {
      if (!flag) flag = value;
    }
    ~Within() { flag_ = before_; }
    Within(Within const &) = delete;
    Within &operator=(Within const &) = delete;

  private:
    Flag &flag_;
    Flag const before_;
  };

  SourceMap const &map_;
  Reals const &reals_;
  Passive passive_ = not_passive;  // double stays double
  bool no_state_ = false;          // nothing is read or written while the program runs
  bool in_template_ = false;       // types may depend on its arguments
  bool is_template_value_ = false; // an argument of a template, which the compiler evaluates
  clang::FunctionDecl const *function_ = nullptr;

private:
  static bool is_allocation(clang::FunctionDecl const *function) {
    clang::OverloadedOperatorKind const kind = function->getOverloadedOperator();
    if (kind == clang::OO_New || kind == clang::OO_Delete || kind == clang::OO_Array_New ||
        kind == clang::OO_Array_Delete)
      return true;
    return function->isExternC() && library::has(function->getName(), library::ALLOCATES);
  }
};

} // namespace symreal::rewrite
