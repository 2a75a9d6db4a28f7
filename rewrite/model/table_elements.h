// Elements of arrays: the indexed object of subscripts, and elements that are more than read.
#pragma once

#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <set>
#include <vector>

namespace symreal::rewrite {

// The indexed object of an element, such as `a` of a[i], an array, a pointer, std::array or std::vector; appends its
// index. Null for any other expression.
clang::Expr const *subscripted(clang::Expr const *expression, std::vector<clang::Expr const *> &indices);

// Texts of objects whose elements are assigned, or whose address is taken, somewhere in the source, in a macro or a
// file that is included again: an expansion that reads elements there may write them elsewhere.
std::set<Span> shared_and_written(clang::ASTContext &context, SourceMap const &map);

} // namespace symreal::rewrite
