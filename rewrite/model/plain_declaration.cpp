#include "rewrite/model/plain_declaration.h"

#include <clang/AST/QualTypeNames.h>

namespace symreal::rewrite {

using namespace clang;

std::string type_text(QualType type, ASTContext const &context) {
  PrintingPolicy policy(context.getLangOpts());
  policy.SuppressUnwrittenScope = true;
  policy.SuppressTagKeyword = true;
  return TypeName::getFullyQualifiedName(type, context, policy);
}

std::string declared(QualType type, std::string name, ASTContext const &context) {
  TypeName::getFullyQualifiedType(type, context).getAsStringInternal(name, PrintingPolicy(context.getLangOpts()));
  return name;
}

std::string name_of(ParmVarDecl const *parameter) {
  std::string const name = parameter->getName().str();
  return name.empty() ? "symreal_argument_" + std::to_string(parameter->getFunctionScopeIndex()) : name;
}

// Another function of that name.
static bool is_overloaded(FunctionDecl const *function) {
  for (NamedDecl const *other : function->getDeclContext()->getRedeclContext()->lookup(function->getDeclName()))
    if (isa<FunctionDecl, FunctionTemplateDecl>(other) && other->getCanonicalDecl() != function->getCanonicalDecl())
      return true;
  return false;
}

std::optional<Signature> plain_declaration(FunctionDecl const *function, LangOptions const &language) {
  bool const is_global = function->getDeclContext()->getRedeclContext()->isTranslationUnit();
  if (!is_global || function->isVariadic() || function->isTemplated() || function->getPrimaryTemplate() ||
      !function->getDeclName().isIdentifier() || is_overloaded(function))
    return {};
  ASTContext const &context = function->getASTContext();
  std::string parameters, arguments;
  for (ParmVarDecl const *parameter : function->parameters()) {
    std::string const name = name_of(parameter);
    QualType const type = parameter->getType();
    if (!parameters.empty()) parameters += ", ", arguments += ", ";
    parameters += declared(parameter->getOriginalType(), name, context);
    arguments +=
        type->isRValueReferenceType() ? "static_cast<" + declared(type, "", context) + ">(" + name + ")" : name;
  }
  if (parameters.empty() && !language.CPlusPlus) parameters = "void";
  std::string text = declared(function->getReturnType(), function->getNameAsString() + "(" + parameters + ")", context);
  Signature signature{text, arguments, !function->getReturnType()->isVoidType()};
  if (!language.CPlusPlus) return signature;
  auto const *type = function->getType()->getAs<FunctionProtoType>();
  if (type && type->getExceptionSpecType() == EST_BasicNoexcept) signature.declaration += " noexcept";
  if (function->isExternC()) signature.declaration.insert(0, "extern \"C\" ");
  return signature;
}

} // namespace symreal::rewrite
