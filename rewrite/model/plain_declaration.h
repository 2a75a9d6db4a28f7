// A function declared anew.
#pragma once

#include "rewrite/facts/signature.h"
#include "rewrite/source/clang.h"

namespace symreal::rewrite {

// Of a function that can be declared again under another name: its declaration from the syntax tree, without default
// arguments, and the arguments that pass its parameters on. Parameters without a name have one here. Nothing for a
// member, a template, a function in a namespace, one with variable arguments or other functions of its name.
std::optional<Signature> plain_declaration(clang::FunctionDecl const *function, clang::LangOptions const &language);

// The type and the name that it declares, whatever stands around it: double (*name)(double), double name[3]. Types have
// all their scopes.
// The type in words that are right in any scope.
std::string type_text(clang::QualType type, clang::ASTContext const &context);

std::string declared(clang::QualType type, std::string name, clang::ASTContext const &context);

// The name of a parameter in what is declared here.
std::string name_of(clang::ParmVarDecl const *parameter);

} // namespace symreal::rewrite
