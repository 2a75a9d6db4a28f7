// The line of a source that a message is about, with a mark below the column.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <string>

namespace symreal {

//    12 |   return (int)x;
//       |               ^
// Nothing where the file cannot be read, has no such line or that is too long to show.
std::string marked_line(Place const &place);

} // namespace symreal
