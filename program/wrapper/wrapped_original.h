// A program that tries a wrapper: the original, where the kernel's function first does what the wrapper does, and goes
// on with its own statements only where a guard does not hold.
#pragma once

#include "program/record/front.h"

namespace symreal::program {

// Puts `statements` where the kernel's function is entered and its arguments have their numbers, `before` where it
// begins, and `top` at the beginning of its file, with <typeinfo> where that is wanted. Lines stay where they are.
void insert_in_wrapper_place(rewrite::Result &annotated, rewrite::Kernel const &kernel, std::string const &statements,
                             std::string const &top, bool with_classes, std::string const &before = "");

// Does the wrapper's file have the statements that belong to this kernel?
bool is_wrapper_of(std::string const &text, Recorded const &recorded);

// The executable. For kernels of functions. Where SYMREAL_VARY is the number of a variation
// (program/wrapper/wrapper_variations.h), the program makes that when it enters the function; where it is that number
// below zero, it goes on with its own statements.
std::string build_wrapped(Front const &front, Recorded const &recorded);

} // namespace symreal::program
