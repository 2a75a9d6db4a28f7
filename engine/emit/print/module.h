// The parts of a file that come from the patterns of language/module.h.
#pragma once

#include "engine/emit/language/pattern.h"
#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// Interface names and sizes for the patterns (language/module.h).
Filling interface_names(Emission const &emission);

// Sizes, object offsets, structures of objects, remarks.
std::string module_begin(Emission const &emission);
// Texts of the guards, and the end of the file.
std::string module_end(Emission const &emission);
std::string module_main(Emission const &emission);

// Values for the patterns of a main program, except $call.
Filling module_facts(Emission const &emission);
// The values of a list, several per line.
std::string lines_of(Language const &language, std::vector<std::string> const &values);

// Text indented for its place between the functions of a file.
std::string indented(Language const &language, std::string const &text);

} // namespace symreal
