// Parser of a line printed by gcc, clang or a linker: FILE:LINE:COLUMN: KIND: TEXT. Text is parsed because gcc's JSON
// omits template instantiations and macro expansions, which users need.
#pragma once

#include "engine/diagnostics/diagnostic.h"

#include <optional>
#include <string>
#include <string_view>

namespace symreal::program {

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

} // namespace symreal::program
