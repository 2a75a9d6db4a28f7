#include "program/build/message_line.h"

#include <charconv>

namespace symreal::program {
namespace {

// Consumes a colon and the number behind it; else returns 0.
unsigned take_number(std::string_view &text) {
  unsigned number = 0;
  if (!text.starts_with(':')) return 0;
  auto const [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc()) return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

} // namespace

std::optional<std::string> MessageLine::text(std::string_view kind) const {
  std::string_view said = rest;
  if (!said.starts_with(": ")) return {};
  said.remove_prefix(2);
  if (!said.starts_with(kind) || !said.substr(kind.size()).starts_with(": ")) return {};
  return std::string(said.substr(kind.size() + 2));
}

std::string MessageLine::text() const {
  std::size_t const begin = rest.find_first_not_of(": ");
  return begin == rest.npos ? "" : rest.substr(begin);
}

std::optional<MessageLine> message_line(std::string_view line) {
  MessageLine message;
  for (std::string_view const words : {"In file included from ", "                 from "})
    if (line.starts_with(words)) message.before = words;
  line.remove_prefix(message.before.size());
  std::size_t const colon = line.find(':');
  if (colon == 0 || colon == line.npos) return {};
  message.place.file = line.substr(0, colon);
  line.remove_prefix(colon);
  message.place.line = take_number(line);
  message.place.column = message.place.line == 0 ? 0 : take_number(line);
  message.rest = line;
  return message;
}

} // namespace symreal::program
