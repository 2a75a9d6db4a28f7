// A function declared anew.
#pragma once

#include "rewrite/clang.h"

#include <string>

namespace symreal::rewrite {

// What Kernel::signature has of a function that can be declared again under another name: its declaration from the
// syntax tree, without default arguments, a line break, and the arguments that pass its parameters on. Parameters
// without a name have one here. Empty for a member, a template, a function in a namespace, one with variable arguments.
std::string plain_declaration(clang::FunctionDecl const *function, clang::LangOptions const &language);

} // namespace symreal::rewrite
