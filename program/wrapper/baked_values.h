// Values that a recording bakes in although each call may change them: arguments that are not inputs, objects that
// `constant` names, integers of annotated objects that the kernel reads.
//
// The original's recorded call provides the values, on entry to the kernel's function. A wrapper compares them with
// those of its own call.
#pragma once

#include "program/record/front.h"

#include "program/wrapper/baked_shape.h"
#include <map>
#include <span>

namespace symreal::program {

using Refusals = std::map<Recorded const *, Diagnostic>;

// Fills in `baked` for function kernels: builds the original with statements that print the values, and runs it for
// each. Builds nothing if there are no values. Returns the kernels that have no wrapper, since a value cannot be
// compared, and why.
Refusals add_baked_values(Front const &front, RunOptions const &run, std::span<Recorded *const> kernels);

// Statements that compare every value. On a difference the call ends with a message, or symreal_same becomes 0.
enum class Otherwise { refuse, remember };
std::string baked_checks(Recorded const &recorded, Otherwise otherwise);

// Helpers of the checks, in blocks of lines of C99 or C++11; empty if there is nothing to compare.
std::vector<std::string> baked_helpers(Recorded const &recorded);

// Does a check compare an object's class, which takes <typeinfo>?
bool compares_classes(Recorded const &recorded);

// Name of a check on the overlap of two items.
std::string overlap_label(rewrite::Overlap const &overlap);

// Loops over an object's recorded values.
std::string baked_statements(BakedObject const &object, BakedLeaf const &leaf);

} // namespace symreal::program
