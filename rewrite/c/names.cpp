#include "rewrite/c/names.h"

#include "rewrite/c/walk.h"
#include "rewrite/facts/own_names.h"
#include "rewrite/model/library_names.h"
#include "rewrite/model/reals.h"

namespace symreal::rewrite {
namespace {

using namespace clang;

class Names : public CWalk {
public:
  using CWalk::CWalk;

  bool VisitNamedDecl(NamedDecl *declaration) override {
    rename(*declaration, declaration->getLocation());
    return true;
  }
  // Symbolic mode has a declaration of its own.
  bool VisitFunctionDecl(FunctionDecl *function) override {
    SourceLocation const at = function->getLocation();
    if (!Reals::is_declared_math(function) || !map_.in_roots(at) || is_rewritten(at)) return true;
    if (!insert(map_.token(at, function->getName()), Use::of_library, function->getNameAsString()))
      report(at, "a macro makes '" + function->getNameAsString() + "', which is a function of the C library");
    return true;
  }
  bool VisitDeclRefExpr(DeclRefExpr *use) override {
    rename(*use->getDecl(), use->getLocation());
    return true;
  }
  bool VisitTypedefTypeLoc(TypedefTypeLoc use) override {
    rename(*use.getTypedefNameDecl(), use.getNameLoc());
    return true;
  }

  bool VisitTagDecl(TagDecl *tag) override {
    rename_tag(*tag, tag->getLocation());
    return true;
  }
  bool VisitTagTypeLoc(TagTypeLoc use) override {
    rename_tag(*use.getDecl(), use.getNameLoc());
    return true;
  }

private:
  void rename(NamedDecl const &declaration, SourceLocation at) {
    if (!declaration.getIdentifier() || !is_library_name(declaration.getName()) || !is_own(declaration)) return;
    std::string const name = declaration.getNameAsString();
    bool const is_known_outside = isa<FunctionDecl, VarDecl>(declaration) && declaration.hasExternalFormalLinkage();
    std::optional<Span> const token = map_.in_roots(at) ? map_.token(at, name) : std::nullopt;
    if (is_known_outside && is_defined(declaration)) facts_.definitions.insert(definition_of(name));
    if (!is_known_outside && token) facts_.definitions.insert(definition_of(name, token->file));
    if (!map_.in_roots(at) || map_.is_argument_of(at, "REAL_NAME")) return;
    if (!insert(token, Use::own_name, name))
      report(at, "a macro makes '" + name + "', which is a name of the C library too");
  }

  // Whether the name is declared at file scope, and by no header of a library.
  bool is_own(NamedDecl const &declaration) {
    if (!isa<FunctionDecl, VarDecl, TypedefNameDecl, EnumConstantDecl>(declaration)) return false;
    DeclContext const *context = declaration.getDeclContext()->getRedeclContext();
    if (!context->isTranslationUnit()) return false;
    for (Decl const *one : declaration.redecls())
      if (!one->isImplicit() && !map_.in_roots(one->getLocation())) {
        if (auto const *function = dyn_cast<FunctionDecl>(&declaration); function && is_defined(declaration))
          defines_library(*function);
        return false;
      }
    return true;
  }
  static bool is_defined(NamedDecl const &declaration) {
    if (auto const *function = dyn_cast<FunctionDecl>(&declaration)) return function->isDefined();
    auto const *variable = dyn_cast<VarDecl>(&declaration);
    return variable && variable->hasDefinition() != VarDecl::DeclarationOnly;
  }
  void defines_library(FunctionDecl const &function) {
    if (!function.doesThisDeclarationHaveABody() || !defined_.insert(&function).second) return;
    auto const is_double = [](QualType type) { return type->isSpecificBuiltinType(BuiltinType::Double); };
    if (is_double(function.getReturnType()) ||
        std::any_of(function.param_begin(), function.param_end(),
                    [&](ParmVarDecl const *one) { return is_double(one->getType()); }))
      report(function.getLocation(), "'" + function.getNameAsString() +
                                         "' is a function of the C library, which a header declares and the program "
                                         "defines itself");
  }

  void rename_tag(TagDecl const &tag, SourceLocation at) {
    if (!tag.getIdentifier() || !map_.in_roots(at) || is_rewritten(at)) return;
    for (NamedDecl const *other : tag.getDeclContext()->getRedeclContext()->lookup(tag.getDeclName())) {
      auto const *type = dyn_cast<TypedefNameDecl>(other);
      if (!type) continue;
      TagDecl const *named = type->getUnderlyingType()->getAsTagDecl();
      if (named && named->getCanonicalDecl() == tag.getCanonicalDecl()) continue;
      if (!insert(map_.token(at, tag.getName()), Use::instead, "symreal_tag_" + tag.getNameAsString()))
        report(at, "a macro makes '" + tag.getNameAsString() + "', which is a tag and the name of another type");
      return;
    }
  }

  llvm::SmallPtrSet<FunctionDecl const *, 4> defined_;
};

} // namespace

void collect_c_names(ASTContext &context, SourceMap const &map, Facts &facts) {
  if (!map.language().CPlusPlus) Names(context, map, facts).TraverseDecl(context.getTranslationUnitDecl());
}

} // namespace symreal::rewrite
