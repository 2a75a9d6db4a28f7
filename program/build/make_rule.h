// Makefile rules for the inputs of a file, in the dialect shared by make, ninja and CMake.
#pragma once

#include <string>
#include <vector>

namespace symreal::program {

// The name, escaped for make.
std::string make_escaped(std::string const &name);

// Names that get a rule without prerequisites, lest removing a file stop the build.
enum class Phony { none, all_but_first, all };

// Formats a rule as gcc does. `targets` are escaped already.
std::string make_rule(std::vector<std::string> const &targets, std::vector<std::string> const &names,
                      Phony phony = Phony::none);

// Prerequisites of a rule with one target.
std::vector<std::string> read_make_rule(std::string const &text);

} // namespace symreal::program
