// What a recording has baked in and each call may give anew: arguments that are no inputs, objects that `constant`
// names, integers of annotated objects that the kernel has read.
//
// Their values are those that the recorded call of the original finds when it enters the kernel's function. A wrapper
// compares them with what it is given.
#pragma once

#include "program/record/front.h"

#include <functional>

namespace symreal::program {

// Fills in `baked` of a kernel of a function: builds the original, with statements that tell the values, and runs it.
// Nothing is built where there is nothing to compare. Throws no_wrapper for what cannot be compared.
void add_baked_values(Front const &front, RunOptions const &run, Recorded &recorded);

// Compares every value. Where it is another one, the call ends with a message, or symreal_same becomes 0.
enum class Otherwise { refuse, remember };
std::string baked_checks(Recorded const &recorded, Otherwise otherwise);

// What the checks use, in blocks of lines of C99 or C++11; none where there is nothing to compare.
std::vector<std::string> baked_helpers(Recorded const &recorded);

// Is an object compared by its class, which takes <typeinfo>?
bool compares_classes(Recorded const &recorded);

// The name of a check on how two items lie.
std::string overlap_label(rewrite::Overlap const &overlap);

// Loops over the values of an object, around what `leaf` makes of each by its kind (rewrite/model/baked_values.h).
using BakedLeaf = std::function<std::string(std::string const &element, char kind)>;
std::string baked_statements(BakedObject const &object, BakedLeaf const &leaf);

} // namespace symreal::program
