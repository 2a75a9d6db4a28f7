// References from code: functions, variables that outlive a call, and tables of classes with virtual functions.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/walk.h"

#include <utility>
#include <vector>

namespace symreal::rewrite {

class References : public Walk {
public:
  using Place = clang::SourceLocation;
  std::vector<std::pair<clang::FunctionDecl const *, Place>> functions;
  std::vector<clang::VarDecl const *> variables;
  std::vector<std::pair<clang::CXXRecordDecl const *, Place>>
      tables; // constructions and class queries, which use the virtual table

  void of(clang::FunctionDecl const *definition) {
    TraverseStmt(definition->getBody());
    if (auto const *constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(definition))
      for (clang::CXXCtorInitializer const *initializer : constructor->inits())
        if (initializer->getInit()) TraverseStmt(initializer->getInit());
  }

  bool shouldVisitImplicitCode() const override { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr *) override { return true; }
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr *) override { return true; }
  bool TraverseTypeLoc(clang::TypeLoc) override { return true; }

  bool VisitDeclRefExpr(clang::DeclRefExpr *reference) override {
    return add(reference->getDecl(), reference->getLocation());
  }
  bool VisitMemberExpr(clang::MemberExpr *member) override {
    return add(member->getMemberDecl(), member->getMemberLoc());
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr *construction) override {
    tables.emplace_back(construction->getConstructor()->getParent(), construction->getLocation());
    return add(construction->getConstructor(), construction->getLocation());
  }
  bool VisitCXXDynamicCastExpr(clang::CXXDynamicCastExpr *cast) override {
    if (clang::CXXRecordDecl const *to = cast->getType()->getPointeeCXXRecordDecl())
      tables.emplace_back(to, cast->getBeginLoc());
    return true;
  }
  bool VisitCXXDeleteExpr(clang::CXXDeleteExpr *deletion) override {
    return deletion->getDestroyedType().isNull() || destroyed(deletion->getDestroyedType(), deletion->getBeginLoc());
  }
  bool VisitCXXBindTemporaryExpr(clang::CXXBindTemporaryExpr *temporary) override {
    return add(temporary->getTemporary()->getDestructor(), temporary->getBeginLoc());
  }
  bool VisitVarDecl(clang::VarDecl *variable) override {
    return destroyed(variable->getType(), variable->getLocation());
  }
  bool VisitCXXDefaultArgExpr(clang::CXXDefaultArgExpr *argument) override { return TraverseStmt(argument->getExpr()); }
  bool VisitCXXDefaultInitExpr(clang::CXXDefaultInitExpr *initializer) override {
    return TraverseStmt(initializer->getExpr());
  }

private:
  bool add(clang::Decl const *declaration, Place place) {
    if (auto const *function = llvm::dyn_cast_or_null<clang::FunctionDecl>(declaration))
      functions.emplace_back(function, place);
    if (auto const *variable = llvm::dyn_cast_or_null<clang::VarDecl>(declaration);
        variable && variable->hasGlobalStorage())
      variables.push_back(variable);
    return true;
  }
  bool destroyed(clang::QualType type, Place place) {
    auto const *record = type->getBaseElementTypeUnsafe()->getAsCXXRecordDecl();
    return !record || !record->hasDefinition() || add(record->getDestructor(), place);
  }
};

} // namespace symreal::rewrite
