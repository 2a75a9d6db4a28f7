// What stands at spans, and which of them meet.
#pragma once

#include "rewrite/facts/facts.h"

namespace symreal::rewrite {

// Do any of the sorted, disjoint spans overlap this one?
bool meets(std::set<Span> const &spans, Span const &span);

// What stands there.
std::string text_of(Span const &span, Facts const &facts);

Place place_in(FileFact const &file, std::size_t offset);

// Would a macro around the expression stand in an argument that becomes text? An expression may also hold the whole
// macro call.
bool is_quoted(Facts const &facts, Span const &expression);

} // namespace symreal::rewrite
