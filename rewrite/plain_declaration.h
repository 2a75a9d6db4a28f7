// A function declared anew.
#pragma once

#include "rewrite/clang.h"
#include "rewrite/rewrite.h"

namespace symreal::rewrite {

// Of a function that can be declared again under another name: its declaration from the syntax tree, without default
// arguments, and the arguments that pass its parameters on. Parameters without a name have one here. Nothing for a
// member, a template, a function in a namespace, one with variable arguments.
std::optional<Signature> plain_declaration(clang::FunctionDecl const *function, clang::LangOptions const &language);

} // namespace symreal::rewrite
