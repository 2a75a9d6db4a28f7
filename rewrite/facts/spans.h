// Queries on spans: their text, their place, and overlaps.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Whether any of the sorted, disjoint spans overlaps this one.
bool meets(std::set<Span> const &spans, Span const &span);

std::string text_of(Span const &span, Facts const &facts);

Place place_in(FileFact const &file, std::size_t offset);

// Whether a macro around the expression would stand in an argument that becomes text. An expression may also hold the
// whole macro call.
bool is_quoted(Facts const &facts, Span const &expression);

} // namespace symreal::rewrite
