#include "rewrite/source/walk.h"

#include <clang/AST/RecursiveASTVisitor.h>

namespace symreal::rewrite {

using namespace clang;

class Walk::Traversal : public RecursiveASTVisitor<Traversal> {
public:
  using Base = RecursiveASTVisitor<Traversal>;

  explicit Traversal(Walk &walk) : walk_(walk) {}

  bool shouldVisitTemplateInstantiations() const { return walk_.shouldVisitTemplateInstantiations(); }
  bool shouldVisitImplicitCode() const { return walk_.shouldVisitImplicitCode(); }
  bool shouldTraversePostOrder() const { return walk_.shouldTraversePostOrder(); }

  bool TraverseDecl(Decl *declaration) { return walk_.TraverseDecl(declaration); }
  bool TraverseTypeLoc(TypeLoc type) { return walk_.TraverseTypeLoc(type); }
  bool TraverseNestedNameSpecifierLoc(NestedNameSpecifierLoc name) {
    return walk_.TraverseNestedNameSpecifierLoc(name);
  }
  bool TraverseLambdaCapture(LambdaExpr *lambda, LambdaCapture const *capture, Expr *initializer) {
    return walk_.TraverseLambdaCapture(lambda, capture, initializer);
  }
  bool TraverseTemplateArgumentLoc(TemplateArgumentLoc const &argument) {
    return walk_.TraverseTemplateArgumentLoc(argument);
  }
  bool TraverseConceptExprRequirement(concepts::ExprRequirement *requirement) {
    return walk_.TraverseConceptExprRequirement(requirement);
  }
#define ENTERED_NODE(CLASS)                                                                                            \
  bool Traverse##CLASS(CLASS *node) { return walk_.Traverse##CLASS(node); }
#define ENTERED_TYPE(CLASS)                                                                                            \
  bool Traverse##CLASS(CLASS type) { return walk_.Traverse##CLASS(type); }
  SYMREAL_ENTERED_STATEMENTS(ENTERED_NODE)
  SYMREAL_ENTERED_DECLARATIONS(ENTERED_NODE)
  SYMREAL_ENTERED_TYPES(ENTERED_TYPE)
#undef ENTERED_NODE
#undef ENTERED_TYPE

#define STMT(CLASS, PARENT)                                                                                            \
  bool Visit##CLASS(CLASS *node) { return walk_.Visit##CLASS(node); }
#include <clang/AST/StmtNodes.inc>
#define DECL(CLASS, PARENT)                                                                                            \
  bool Visit##CLASS##Decl(CLASS##Decl *node) { return walk_.Visit##CLASS##Decl(node); }
#include <clang/AST/DeclNodes.inc>
#define TYPELOC(CLASS, PARENT)                                                                                         \
  bool Visit##CLASS##TypeLoc(CLASS##TypeLoc type) { return walk_.Visit##CLASS##TypeLoc(type); }
#include <clang/AST/TypeLocNodes.def>
  bool VisitStmt(Stmt *node) { return walk_.VisitStmt(node); }
  bool VisitDecl(Decl *node) { return walk_.VisitDecl(node); }

private:
  Walk &walk_;
};

bool Walk::TraverseStmt(Stmt *statement) { return Traversal(*this).TraverseStmt(statement); }
bool Walk::TraverseDecl(Decl *declaration) { return Traversal(*this).Base::TraverseDecl(declaration); }
bool Walk::TraverseTypeLoc(TypeLoc type) { return Traversal(*this).Base::TraverseTypeLoc(type); }
bool Walk::TraverseNestedNameSpecifierLoc(NestedNameSpecifierLoc name) {
  return Traversal(*this).Base::TraverseNestedNameSpecifierLoc(name);
}
bool Walk::TraverseLambdaCapture(LambdaExpr *lambda, LambdaCapture const *capture, Expr *initializer) {
  return Traversal(*this).Base::TraverseLambdaCapture(lambda, capture, initializer);
}
bool Walk::TraverseTemplateArgumentLoc(TemplateArgumentLoc const &argument) {
  return Traversal(*this).Base::TraverseTemplateArgumentLoc(argument);
}
bool Walk::TraverseConceptExprRequirement(concepts::ExprRequirement *requirement) {
  return Traversal(*this).Base::TraverseConceptExprRequirement(requirement);
}
#define ENTERED_NODE(CLASS)                                                                                            \
  bool Walk::Traverse##CLASS(CLASS *node) { return Traversal(*this).Base::Traverse##CLASS(node); }
#define ENTERED_TYPE(CLASS)                                                                                            \
  bool Walk::Traverse##CLASS(CLASS type) { return Traversal(*this).Base::Traverse##CLASS(type); }
SYMREAL_ENTERED_STATEMENTS(ENTERED_NODE)
SYMREAL_ENTERED_DECLARATIONS(ENTERED_NODE)
SYMREAL_ENTERED_TYPES(ENTERED_TYPE)
#undef ENTERED_NODE
#undef ENTERED_TYPE

#define STMT(CLASS, PARENT)                                                                                            \
  bool Walk::Visit##CLASS(CLASS *) { return true; }
#include <clang/AST/StmtNodes.inc>
#define DECL(CLASS, PARENT)                                                                                            \
  bool Walk::Visit##CLASS##Decl(CLASS##Decl *) { return true; }
#include <clang/AST/DeclNodes.inc>
#define TYPELOC(CLASS, PARENT)                                                                                         \
  bool Walk::Visit##CLASS##TypeLoc(CLASS##TypeLoc) { return true; }
#include <clang/AST/TypeLocNodes.def>
bool Walk::VisitStmt(Stmt *) { return true; }
bool Walk::VisitDecl(Decl *) { return true; }

std::vector<ReturnStmt const *> returns_of(FunctionDecl const *function) {
  class Returns : public Walk {
  public:
    bool TraverseLambdaExpr(LambdaExpr *) override { return true; }
    bool TraverseCXXRecordDecl(CXXRecordDecl *) override { return true; }
    bool VisitReturnStmt(ReturnStmt *statement) override {
      found.push_back(statement);
      return true;
    }
    std::vector<ReturnStmt const *> found;
  };
  Returns returns;
  returns.TraverseStmt(function->getBody());
  return std::move(returns.found);
}

} // namespace symreal::rewrite
