// Program that tests wrappers: each kernel's function in the original first runs its wrapper's statements, and
// continues with its own only if a guard fails.
#pragma once

#include "program/record/front.h"

#include <span>
#include <string>
#include <vector>

namespace symreal::program {

// Text that the original gets at a kernel's function. Line numbers stay.
struct Insertion {
  rewrite::Kernel const *kernel;
  std::string statements;          // where the function is entered and its arguments have their numbers
  std::string before;              // where it begins
  std::vector<std::string> blocks; // declarations at the beginning of its file
  bool with_classes;               // with <typeinfo>
};

// Condition that the program runs for this kernel, which entry `replay_kernel` of the request names: the program has
// statements for others as well.
std::string is_run_of(Recorded const &recorded);

// Builds the original with these insertions; returns the executable. `directory`: of its texts in the workspace.
std::string build_with(Front const &front, std::vector<Insertion> const &insertions, std::string const &directory);

// Does the wrapper's file have the statements for this kernel?
bool is_wrapper_of(std::string const &text, Recorded const &recorded);

// Builds the program for function kernels; returns the executable. If entry `vary` of the request is the number of a
// variation (wrapper_variations), the function applies it on entry; if it is the negated number, the function also
// skips the wrapper's statements.
std::string build_wrapped(Front const &front, std::span<Recorded const *const> kernels);

// Variations of the recorded call that a wrapper must notice, since they change what the recording bakes in: other
// values, other extents, overlapping arguments. Classes, and data that only templates reach, stay.
struct Variation {
  std::string where;       // description, behind "the original"
  std::string statement;   // runs once the arguments have their numbers
  std::string before = {}; // runs at the function's begin
};
std::vector<Variation> wrapper_variations(Recorded const &recorded);

} // namespace symreal::program
