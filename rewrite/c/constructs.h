// Constructs of C that C++ does not have or understands differently. Each function turns one kind of them, in a source
// in C, into what C++ takes, and reports those that macros spell in parts.
#pragma once

#include "rewrite/model/reals.h"

namespace symreal::rewrite {

// Names that clash in C++: with the C library's, more of whose headers symbolic mode includes, and a tag with a type's
// name.
void collect_c_names(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Reports uses of names that would be others in C++, and structures of another size.
void collect_c_declarations(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Declaration specifiers: `auto` beside a type, a missing type, which is int, and a structure defined in a function's
// return type.
void collect_c_specifiers(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Gives each anonymous structure that holds REALs a name, in its declaration and at the uses of its members: C++
// forbids members of class type in anonymous structures. In sources in C++ as well, where compilers allow them.
void collect_anonymous_structs(clang::ASTContext &context, SourceMap const &map, Reals const &reals, Facts &facts);

// Arrays of characters without room for the zero behind them, and parameters that say how long they are:
// `double a[n][n]`, `double a[static 3]`.
void collect_c_arrays(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Compound literals: `(struct pair){1, x}` is an lvalue in C, which lives as long as the block around it. In C++, as
// gcc has it, it is an rvalue, whose address cannot be taken.
void collect_c_literals(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Generic selections: the punctuation of _Generic becomes arguments for a macro of the same name (<symreal/of_c.h>).
void collect_c_generic(clang::ASTContext &context, SourceMap const &map, Facts &facts);

// Each initialisation that a `case`, a `default` or a `goto` jumps past becomes an assignment: C++ forbids such jumps.
void collect_c_jumps(clang::ASTContext &context, SourceMap const &map, Facts &facts);

} // namespace symreal::rewrite
