// What a file was made from, in the form that make, ninja and CMake read.
#pragma once

#include <string>
#include <vector>

namespace symreal::program {

// A name as make reads it.
std::string make_escaped(std::string const &name);

// The rule as gcc lays it out. The targets are escaped already. `phony`: a rule without prerequisites for each name but
// the first, lest a header that is removed stop the build.
std::string make_rule(std::vector<std::string> const &targets, std::vector<std::string> const &names,
                      bool phony = false);

// The names that a rule with one target lists.
std::vector<std::string> read_make_rule(std::string const &text);

} // namespace symreal::program
