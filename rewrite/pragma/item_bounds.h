// Whether the elements that an item names exist.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/model/item_type.h"

#include <vector>

namespace symreal::rewrite {

// An element beyond an object whose size is known from declarations is an error; where only the run knows the size, or
// the element, the annotation tests it (ItemFact::tested). `indices`: the brackets of the item's expression.
void note_bounds(ClauseFact const &clause, ItemFact &item, std::vector<ItemIndex> const &indices, LookUp look_up,
                 Facts &facts);

} // namespace symreal::rewrite
