// Source line of a message, with a mark below the column.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <string>

namespace symreal {

//    12 |   return (int)x;
//       |               ^
// Empty if the file is unreadable, lacks the line, or the line is too long to show.
std::string marked_line(Place const &place);

} // namespace symreal
