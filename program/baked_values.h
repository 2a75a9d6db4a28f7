// What a recording has baked in and each call may give anew: arguments that are no inputs, objects that `constant`
// names, integers of annotated objects that the kernel has read.
//
// Their values are those that the recorded call of the original finds when it enters the kernel's function. A wrapper
// compares them with what it is given.
#pragma once

#include "program/front.h"

#include <functional>

namespace symreal::program {

// Fills in `baked` of a kernel of a function: builds the original, with statements that tell the values, and runs it.
// Nothing is built where there is nothing to compare. Throws no_wrapper for what cannot be compared.
void add_baked_values(Front const &front, RunOptions const &run, Recorded &recorded);

// For every value, the statement `otherwise` where it is another one; `label` names the object.
using Otherwise = std::function<std::string(std::string const &label)>;
std::string baked_checks(Recorded const &recorded, Otherwise const &otherwise);

// What the checks use, in blocks of lines of C99 or C++11; none where there is nothing to compare.
std::vector<std::string> baked_helpers(Recorded const &recorded);

// Is an object compared by its class, which takes <typeinfo>?
bool compares_classes(Recorded const &recorded);

// Statements that change a value, by number from 1 on, where the variable symreal_varied is that number: what
// verification tries. Text, classes and what only templates reach stay.
struct Variation {
  std::string label, statement;
};
std::vector<Variation> baked_variations(Recorded const &recorded);

} // namespace symreal::program
