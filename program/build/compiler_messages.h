// Output of a host compiler or linker: its lines, and diagnostics on the user's sources from them.
#pragma once

#include "program/build/overlay.h"
#include "program/build/process.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::program {

// A line printed by gcc, clang or a linker: FILE:LINE:COLUMN: KIND: TEXT. Text is parsed because gcc's JSON omits
// template instantiations and macro expansions, which users need.
struct MessageLine {
  std::string before; // "In file included from "
  Place place;        // line and column are 0 if missing
  std::string rest;   // text behind the place, with its colon

  // The text behind a kind such as "error" or "note"; nullopt if the line is of another kind.
  std::optional<std::string> text(std::string_view kind) const;
  // The text of a line without a kind, such as "required from here".
  std::string text() const;
};

// Nullopt if the line names no file.
std::optional<MessageLine> message_line(std::string_view line);

// `command`: the failed command, whose output and exit status explain the failure. `mode`: mode of the program.
Diagnostic compiler_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay,
                            std::string const &mode = "in symbolic mode");
Diagnostic linker_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay);

} // namespace symreal::program
