// Small pieces of text that pragmas become.
#pragma once

#include "rewrite/facts.h"

#include <string>

namespace symreal::rewrite {

// A C string literal of the text.
std::string quoted(std::string const &text);

// `"label", "file", line, column`: what every annotation macro begins with.
std::string place_arguments(std::string const &label, Place const &place);

// `*p`, all that p points to.
bool is_pointee(ItemFact const &item);

// `scratch(file)`: the static variables of the pragma's file. A variable of that name is meant by scratch((file)).
bool means_file(std::string const &clause, ItemFact const &item);

// `"layout", (types)`: what the annotation macros of structures take besides.
std::string layout_arguments(ObjectLayout const &layout);

// Comments away, each run of white space one blank.
std::string normalised(std::string const &source);

// Does the text hold nothing but what can stand between a function pragma and the first token of its function:
// comments, other directives, template and linkage headers?
bool only_declaration_start(std::string const &source);

// `double` as a whole word becomes REAL (in its long form, see type_name.h), unless it is a long double.
std::string with_real(std::string const &source);

// The annotations of a region pragma, on one line.
std::string region_text(PragmaFact const &pragma);

// What stands right after the brace of a function with a pragma.
std::string function_text(PragmaFact const &pragma);

} // namespace symreal::rewrite
