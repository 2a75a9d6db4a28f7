// Texts that replace pragmas.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/text/source_text.h"

#include <string>

namespace symreal::rewrite {

// First arguments of every annotation macro: `"label", "file", line, column`.
std::string place_arguments(std::string const &label, Place const &place);

// A place as arguments: `"file", line, column`.
std::string place_words(Place const &place);

// Expression that an annotation evaluates: the item's, with tests of its indices.
std::string const &evaluated(ItemFact const &item);

// Whether the item is `*p`, all that p points to.
bool is_pointee(ItemFact const &item);

// Whether the item is `scratch(file)`: the static variables of the pragma's file. scratch((file)) names a variable.
bool means_file(Clause clause, ItemFact const &item);

// Whether the item's numbers are given or returned, as an object of them: in an instantiation of a template they may be
// others than REALs.
bool is_counted(Clause clause, ItemFact const &item);

// The call of the function that is the kernel; in a template of the runtime's `space` none where it has other numbers.
std::string call_text(PragmaFact const &pragma, std::string const &space);

// Further arguments of the annotation macros of structures: `"layout", (types)`.
std::string layout_arguments(ObjectLayout const &layout);

// The annotations of a region pragma, on one line.
std::string region_text(PragmaFact const &pragma);

// Whether a function with a pragma is entered at a brace, and not at a function-try-block.
bool is_brace(Span const &entry);

// Text to insert after that brace, or in a block around the function-try-block.
std::string function_text(PragmaFact const &pragma);

} // namespace symreal::rewrite
