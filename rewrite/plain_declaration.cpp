#include "rewrite/plain_declaration.h"

namespace symreal::rewrite {

using namespace clang;

// The type and the name that it declares, whatever stands around it: double (*name)(double), double name[3].
static std::string declared(QualType type, std::string name, PrintingPolicy const &policy) {
  type.getAsStringInternal(name, policy);
  return name;
}

std::optional<Signature> plain_declaration(FunctionDecl const *function, LangOptions const &language) {
  bool const is_global = function->getDeclContext()->getRedeclContext()->isTranslationUnit();
  if (!is_global || function->isVariadic() || function->isTemplated() || function->getPrimaryTemplate() ||
      !function->getDeclName().isIdentifier())
    return {};
  PrintingPolicy const policy(language);
  std::string parameters, arguments;
  for (ParmVarDecl const *parameter : function->parameters()) {
    std::string name = parameter->getName().str();
    if (name.empty()) name = "symreal_argument_" + std::to_string(parameter->getFunctionScopeIndex());
    QualType const type = parameter->getType();
    if (!parameters.empty()) parameters += ", ", arguments += ", ";
    parameters += declared(parameter->getOriginalType(), name, policy);
    arguments += type->isRValueReferenceType() ? "static_cast<" + type.getAsString(policy) + ">(" + name + ")" : name;
  }
  if (parameters.empty() && !language.CPlusPlus) parameters = "void";
  std::string text = declared(function->getReturnType(), function->getNameAsString() + "(" + parameters + ")", policy);
  Signature signature{text, arguments, !function->getReturnType()->isVoidType()};
  if (!language.CPlusPlus) return signature;
  auto const *type = function->getType()->getAs<FunctionProtoType>();
  if (type && type->getExceptionSpecType() == EST_BasicNoexcept) signature.declaration += " noexcept";
  if (function->isExternC()) signature.declaration.insert(0, "extern \"C\" ");
  return signature;
}

} // namespace symreal::rewrite
