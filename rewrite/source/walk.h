// A walk over a syntax tree: a class derives from it and overrides the handlers that it needs.
//
// It is clang::RecursiveASTVisitor with virtual handlers, as Clang has from version 20 on (DynamicRecursiveASTVisitor):
// the traversal is instantiated once, in walk.cpp, and not in each file that walks, which took ten seconds of each.
#pragma once

#include "rewrite/source/clang.h"

#include <utility>
#include <vector>

namespace symreal::rewrite {

// The parts of the tree that a walk may enter in a way of its own. Statements of other kinds are queued by the
// traversal, so that a long chain of operators needs no deep stack.
// clang-format off
#define SYMREAL_ENTERED_STATEMENTS(KIND)                                                                               \
  KIND(CallExpr) KIND(CompoundStmt) KIND(ConstantExpr) KIND(CXXNoexceptExpr) KIND(CXXTypeidExpr) KIND(ForStmt)         \
  KIND(IfStmt) KIND(LambdaExpr) KIND(SwitchStmt) KIND(UnaryExprOrTypeTraitExpr)
#define SYMREAL_ENTERED_DECLARATIONS(KIND)                                                                             \
  KIND(CXXConstructorDecl) KIND(CXXConversionDecl) KIND(CXXDestructorDecl) KIND(CXXMethodDecl) KIND(CXXRecordDecl)     \
  KIND(EnumConstantDecl) KIND(FunctionDecl) KIND(NonTypeTemplateParmDecl) KIND(RecordDecl) KIND(StaticAssertDecl)      \
  KIND(UnresolvedUsingValueDecl) KIND(UsingDecl) KIND(VarDecl)
#define SYMREAL_ENTERED_TYPES(KIND)                                                                                    \
  KIND(ConstantArrayTypeLoc) KIND(DecltypeTypeLoc) KIND(TemplateSpecializationTypeLoc)
// clang-format on

class Walk {
public:
  Walk() = default;
  virtual ~Walk() = default;

  virtual bool shouldVisitTemplateInstantiations() const { return false; }
  virtual bool shouldVisitImplicitCode() const { return false; }
  virtual bool shouldTraversePostOrder() const { return false; }

  // Enter a part of the tree; false ends the walk. An override that calls the function of this class goes on below.
  bool TraverseStmt(clang::Stmt *);
  virtual bool TraverseDecl(clang::Decl *);
  virtual bool TraverseTypeLoc(clang::TypeLoc);
  virtual bool TraverseNestedNameSpecifierLoc(clang::NestedNameSpecifierLoc);
  virtual bool TraverseLambdaCapture(clang::LambdaExpr *, clang::LambdaCapture const *, clang::Expr *initializer);
  virtual bool TraverseTemplateArgumentLoc(clang::TemplateArgumentLoc const &);
  virtual bool TraverseConceptExprRequirement(clang::concepts::ExprRequirement *);
#define ENTERED_NODE(CLASS) virtual bool Traverse##CLASS(clang::CLASS *);
#define ENTERED_TYPE(CLASS) virtual bool Traverse##CLASS(clang::CLASS);
  SYMREAL_ENTERED_STATEMENTS(ENTERED_NODE)
  SYMREAL_ENTERED_DECLARATIONS(ENTERED_NODE)
  SYMREAL_ENTERED_TYPES(ENTERED_TYPE)
#undef ENTERED_NODE
#undef ENTERED_TYPE

  // Visitors of a node; false ends the walk. Called for each class of the node, from the root of the hierarchy on.
#define STMT(CLASS, PARENT) virtual bool Visit##CLASS(clang::CLASS *);
#include <clang/AST/StmtNodes.inc>
#define DECL(CLASS, PARENT) virtual bool Visit##CLASS##Decl(clang::CLASS##Decl *);
#include <clang/AST/DeclNodes.inc>
#define TYPELOC(CLASS, PARENT) virtual bool Visit##CLASS##TypeLoc(clang::CLASS##TypeLoc);
#include <clang/AST/TypeLocNodes.def>
  virtual bool VisitStmt(clang::Stmt *);
  virtual bool VisitDecl(clang::Decl *);

private:
  class Traversal;
};

// The evaluated parts of an expression or a statement, without operands of sizeof and bodies of lambdas.
class EvaluatedWalk : public Walk {
public:
  bool shouldVisitImplicitCode() const override { return true; }
  bool TraverseLambdaExpr(clang::LambdaExpr *) override { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(clang::UnaryExprOrTypeTraitExpr *) override { return true; }
  bool TraverseCXXNoexceptExpr(clang::CXXNoexceptExpr *) override { return true; }
  bool TraverseTypeLoc(clang::TypeLoc) override { return true; }
};

// References from code: functions, variables that outlive a call, and tables of classes with virtual functions.
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

// The `return` statements of the function itself, without those of lambdas and local classes.
std::vector<clang::ReturnStmt const *> returns_of(clang::FunctionDecl const *function);

} // namespace symreal::rewrite
