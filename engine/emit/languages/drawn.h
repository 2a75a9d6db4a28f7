// Languages that are read by people: the names of LaTeX, and the whole of a file of DOT.
#pragma once

#include <string>

namespace symreal {

struct Emission;

std::string latex_variable(std::string const &name);
std::string dot_file(Emission const &emission);

} // namespace symreal
