// What a file was made from, in the form that make, ninja and CMake read.
#pragma once

#include <string>
#include <vector>

namespace symreal::program {

// A name as make reads it.
std::string make_escaped(std::string const &name);

// Which names get a rule without prerequisites of their own, lest the removal of a file stop the build.
enum class Phony { none, all_but_first, all };

// The rule as gcc lays it out. The targets are escaped already.
std::string make_rule(std::vector<std::string> const &targets, std::vector<std::string> const &names,
                      Phony phony = Phony::none);

// The names that a rule with one target lists.
std::vector<std::string> read_make_rule(std::string const &text);

} // namespace symreal::program
