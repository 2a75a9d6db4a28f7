// From facts to what is done about them: the text of each file, the kernels, the diagnostics. Knows no Clang.
#pragma once

#include "rewrite/compose.h"
#include "rewrite/facts.h"

namespace symreal::rewrite {

Result decide(Facts facts);

// What makes selects of decisions, where nothing refuses it (decide_selects.cpp).
void add_selects(Facts &facts, std::map<std::string, std::vector<Rewording>> &rewordings, Result &result);

// Do any of the sorted, disjoint spans overlap this one?
bool meets(std::set<Span> const &spans, Span const &span);

Place place_in(FileFact const &file, std::size_t offset);

// The kernels that the pragmas ask for, and what is wrong with them (kernels.cpp).
void collect_kernels(Facts const &facts, Result &result);

} // namespace symreal::rewrite
