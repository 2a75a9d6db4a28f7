// Program that tests a wrapper: the kernel's function in the original first runs the wrapper's statements, and
// continues with its own only if a guard fails.
#pragma once

#include "program/record/front.h"

#include <string>
#include <vector>

namespace symreal::program {

// Inserts `statements` where the kernel's function is entered and its arguments have their numbers, `before` where it
// begins, and `top` at the beginning of its file, with <typeinfo> if `with_classes`. Line numbers stay.
void insert_in_wrapper_place(rewrite::Result &annotated, rewrite::Kernel const &kernel, std::string const &statements,
                             std::string const &top, bool with_classes, std::string const &before = "");

// Does the wrapper's file have the statements for this kernel?
bool is_wrapper_of(std::string const &text, Recorded const &recorded);

// Builds the program for a function kernel; returns the executable. If entry `vary` of the request is the number of a
// variation (wrapper_variations), the function applies it on entry; if it is the negated number, the function also
// skips the wrapper's statements.
std::string build_wrapped(Front const &front, Recorded const &recorded);

// Variations of the recorded call that a wrapper must notice, since they change what the recording bakes in: other
// values, other extents, overlapping arguments. Classes, and data that only templates reach, stay.
struct Variation {
  std::string where;       // description, behind "the original"
  std::string statement;   // runs once the arguments have their numbers
  std::string before = {}; // runs at the function's begin
};
std::vector<Variation> wrapper_variations(Recorded const &recorded);

} // namespace symreal::program
