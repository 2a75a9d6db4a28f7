// The handlers by concept: each function adds the handlers of its file. Their order does not matter.
#pragma once

#include "rewrite/collect/handler.h"

namespace symreal::rewrite {

class Views;

void add_argument_lists(SyntaxTable &table);      // lists of variable arguments that functions hand on
void add_bytes(SyntaxTable &table, Views &views); // bytes of a REAL that are used as something else
void add_calls(SyntaxTable &table);               // arguments of calls and constructions
void add_constants(SyntaxTable &table);           // constant objects of doubles where objects of REALs are taken
void add_conversions(SyntaxTable &table);         // conversions of numbers, enumerations and pointers
void add_instantiated(SyntaxTable &table);        // conversions that only an instantiation of a template shows
void add_library_calls(SyntaxTable &table); // conversions within a library, errno and its like, results of functions
void add_literals(SyntaxTable &table);      // literals by which a type is deduced
void add_c(SyntaxTable &table);             // constructs of C that C++ does not allow
void add_c_types(SyntaxTable &table);       // expressions of C whose type differs in C++
void add_c_widths(SyntaxTable &table);      // bit-fields of C that are not as wide as int
void add_names_of_functions(
    SyntaxTable &table);                     // functions of <cmath> as values, builtins, functions that C++20 removed
void add_named_numbers(SyntaxTable &table);  // names that the program has for numbers
void add_state(SyntaxTable &table);          // uses of single objects that may outlive a kernel
void add_state_of_calls(SyntaxTable &table); // and of objects that are passed to code that is not rewritten
void add_text(SyntaxTable &table);           // text that is made of REALs, and text that is read
void add_truths(SyntaxTable &table);         // comparisons and integers whose type is looked at
void add_types(SyntaxTable &table);          // types that a source spells, and their names at run time
void add_unions(SyntaxTable &table, Views &views); // members of unions that share their bytes with a number
Views &add_views(SyntaxTable &table);              // pointers to REALs that are taken for pointers to something else

} // namespace symreal::rewrite
