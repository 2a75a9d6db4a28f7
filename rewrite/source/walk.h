// A walk over a syntax tree: a class derives from it and overrides the handlers that it needs.
//
// It is clang::RecursiveASTVisitor with virtual handlers, as Clang has from version 20 on (DynamicRecursiveASTVisitor):
// the traversal is instantiated once, in walk.cpp, and not in each file that walks, which took ten seconds of each.
#pragma once

#include "rewrite/source/clang.h"

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

} // namespace symreal::rewrite
