// Elements of arrays: what a subscript, or several, is of, and where elements are more than read.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <set>
#include <vector>

namespace symreal::rewrite {

// The object that the expression is an element of, if it is one, such as `a` of a[i], an array, a pointer, std::array
// or std::vector; its index is noted. Null for any other expression.
clang::Expr const *subscripted(clang::Expr const *expression, std::vector<clang::Expr const *> &indices);

// The texts of objects whose elements are assigned to, or whose address is taken, somewhere in the source, as far as a
// macro or a file that is included again holds them: what reads elements there may write them elsewhere.
std::set<Span> shared_and_written(clang::ASTContext &context, SourceMap const &map);

} // namespace symreal::rewrite
