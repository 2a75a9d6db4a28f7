// Facts about one source that need a walk of the syntax tree of their own.
#pragma once

#include "rewrite/collect/handler.h"

#include <vector>

namespace symreal::rewrite {

// Finds the integers that stay symbolic in all functions of the roots, and adds them to `reals`; changed spellings go
// to the facts. A use elsewhere (an argument, a loop's bound, another index) converts such an integer back to a plain
// one, which is a decision.
void collect_symbolic_ints(clang::ASTContext &context, SourceMap const &map, Facts &facts, Reals &reals);

// Walks the instantiations of templates and of generic lambdas within the roots.
void collect_instances(Collection const &all);

// Operands with side effects on each other. The language leaves their order open; compilers have one order for built-in
// operators and another for those of a class, and read an argument that is a number at another time than one that is a
// class. The rewriter spells out gcc's order for the original where it matters.
void collect_operand_order(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

// Layout of classes that depends on a number being a class: sizes and offsets are written down for the compiler to
// check, and members are kept out of a base class's padding.
void collect_layouts(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

// Functions of the roots that the program calls and that no source defines: those of a compiled library work on double.
// Only code that is compiled into the program counts; an uncalled inline function of a header may mention any function.
// `definitions`: of functions, within the roots.
void collect_boundaries(clang::ASTContext &context, std::vector<clang::FunctionDecl const *> const &definitions,
                        SourceMap const &map, Reals const &reals, Facts &facts);

// Undefined symbols of each symbol of a source, as its object file will have them. Dead code counts as well: the linker
// needs its definitions.
void collect_links(clang::ASTContext &context, std::vector<clang::FunctionDecl const *> const &definitions,
                   SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
