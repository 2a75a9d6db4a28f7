// Redeclaration of a function under another name.
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// Declaration of a function from the syntax tree, without default arguments, and the arguments that pass its parameters
// on. Parameters without a name have one here. Nullopt unless it can be declared under another name: for a member, a
// template, a function in a namespace, one with variable arguments or other functions of its name.
std::optional<Signature> plain_declaration(clang::FunctionDecl const *function, clang::LangOptions const &language);

// The type as text that is valid in any scope.
std::string type_text(clang::QualType type, clang::ASTContext const &context);
// Declaration of the name with this type: double (*name)(double), double name[3]. Types have all their scopes.
std::string declared(clang::QualType type, std::string name, clang::ASTContext const &context);

// Name of a parameter in such a declaration.
std::string name_of(clang::ParmVarDecl const *parameter);

} // namespace symreal::rewrite
