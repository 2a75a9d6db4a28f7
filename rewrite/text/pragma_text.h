// What pragmas become.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/text/source_text.h"

#include <string>

namespace symreal::rewrite {

// `"label", "file", line, column`: what every annotation macro begins with.
std::string place_arguments(std::string const &label, Place const &place);

// What an annotation evaluates: the item's expression, with tests of its indices.
std::string const &evaluated(ItemFact const &item);

// `*p`, all that p points to.
bool is_pointee(ItemFact const &item);

// `scratch(file)`: the static variables of the pragma's file. A variable of that name is meant by scratch((file)).
bool means_file(Clause clause, ItemFact const &item);

// `"layout", (types)`: what the annotation macros of structures take besides.
std::string layout_arguments(ObjectLayout const &layout);

// The annotations of a region pragma, on one line.
std::string region_text(PragmaFact const &pragma);

// What stands right after the brace of a function with a pragma.
std::string function_text(PragmaFact const &pragma);

} // namespace symreal::rewrite
