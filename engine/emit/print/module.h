// The parts of a file that a language's module.h patterns say.
#pragma once

#include "engine/emit/language/pattern.h"
#include "engine/emit/print/emission.h"

#include <vector>

namespace symreal {

// What the interface calls its parts, and its sizes (language/module.h).
Filling interface_names(Emission const &emission);

// Sizes, where objects begin, structures of them, remarks.
std::string module_begin(Emission const &emission);
// The texts of the guards, and the end.
std::string module_end(Emission const &emission);
std::string module_main(Emission const &emission);

// What the patterns of a main program are filled with, but for $call.
Filling module_facts(Emission const &emission);
// The values of a list, a few on a line.
std::string lines_of(Language const &language, std::vector<std::string> const &values);

// Lines as they stand between the functions of a file.
std::string indented(Language const &language, std::string const &text);

} // namespace symreal
