// A line of what gcc, clang or a linker prints: FILE:LINE:COLUMN: KIND: TEXT. The lines are read, and not the
// compilers' JSON: gcc's leaves out where a template was instantiated and which macro was expanded, which is what a
// user needs.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace symreal::program {

struct MessageLine {
  std::string before; // "In file included from "
  Place place;        // line and column are 0 where there is none
  std::string rest;   // behind the place, with its colon

  // The text of this kind ("error", "note") without it; nothing where the line is of another kind.
  std::optional<std::string> text(std::string_view kind) const;
  // The same of a line without a kind, such as "required from here".
  std::string text() const;
};

// Nothing where the line names no file.
std::optional<MessageLine> message_line(std::string_view line);

} // namespace symreal::program
