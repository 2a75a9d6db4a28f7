#include "program/build/compiler_messages.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <span>
#include <sstream>

namespace symreal::program {
namespace {

constexpr std::size_t most_notes = 4;

// Consumes a colon and the number behind it; else returns 0.
unsigned take_number(std::string_view &text) {
  unsigned number = 0;
  if (!text.starts_with(':')) return 0;
  auto const [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), number);
  if (error != std::errc()) return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

std::vector<std::string> lines_of(std::string const &output) {
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// A line of the output, with its place in the user's source.
struct Line {
  std::optional<MessageLine> message; // nullopt if the line names no line number

  std::optional<std::string> error() const {
    if (!message) return {};
    std::optional<std::string> text = message->text("error");
    return text ? text : message->text("fatal error");
  }
  // The message, if it is not an error and begins with one of these texts.
  std::optional<Note> says(std::initializer_list<std::string_view> beginnings, bool is_note) const {
    if (!message) return {};
    std::string const text = is_note ? message->text("note").value_or("") : message->text();
    bool const fits = std::ranges::any_of(beginnings, [&](std::string_view one) { return text.starts_with(one); });
    return fits ? std::optional<Note>({message->place, text}) : std::nullopt;
  }
};

std::vector<Line> read_lines(std::vector<std::string> const &lines, Overlay const &overlay) {
  std::vector<Line> read;
  for (std::string const &line : lines) {
    Line &one = read.emplace_back(Line{message_line(line)});
    if (one.message && one.message->place.line == 0) one.message.reset();
    if (one.message) one.message->place = overlay.original(one.message->place);
  }
  return read;
}

// Lines that belong to the error in line `at`: up to the next error.
std::span<Line const> behind(std::vector<Line> const &lines, std::size_t at) {
  std::size_t end = at + 1;
  while (end < lines.size() && !lines[end].error()) ++end;
  return std::span(lines).subspan(at + 1, end - at - 1);
}

// The last line before `end` that names an instantiation of a template in the user's source.
std::optional<Note> instantiation(std::vector<Line> const &lines, std::size_t end, Overlay const &overlay) {
  for (std::size_t i = end; i-- > 0 && end - i < 40;)
    if (auto note = lines[i].says({"required from", "in instantiation of"}, false);
        note && overlay.contains(note->place.file))
      return note;
  return {};
}

// Template instantiations that enclose the error in line `at`: gcc lists them before it, clang after it.
std::vector<Note> instantiations(std::vector<Line> const &lines, std::size_t at) {
  std::vector<Note> notes;
  for (std::size_t i = at; i-- > 0 && notes.size() < most_notes;) {
    auto const note = lines[i].says({"required from ", "required by "}, false);
    if (!note) break;
    notes.insert(notes.begin(), *note);
  }
  for (Line const &line : behind(lines, at))
    if (auto const note = line.says({"in instantiation of "}, true); note && notes.size() < most_notes)
      notes.push_back(*note);
  return notes;
}

// The last line after the error that names an enclosing macro of the user's; Symreal's macros stand in a header.
std::optional<Note> expansion(std::vector<Line> const &lines, std::size_t at, Overlay const &overlay) {
  std::optional<Note> last;
  for (Line const &line : behind(lines, at))
    if (auto const note = line.says({"in definition of macro ", "in expansion of macro "}, true);
        note && overlay.contains(note->place.file))
      last = note;
  return last;
}

std::optional<Diagnostic> did_not_start(std::vector<std::string> const &command, Captured const &result) {
  if (result.outcome.ending != Ending::not_started) return {};
  return Diagnostic{DiagnosticId::compiler_missing,
                    {},
                    "the compiler '" + command[0] + "' cannot be run: " + std::strerror(result.outcome.status)};
}

std::vector<Note> first_lines(std::vector<std::string> const &lines) {
  std::vector<Note> notes;
  for (std::string const &line : lines)
    if (!line.empty() && notes.size() < most_notes) notes.push_back({{}, line});
  return notes;
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

Diagnostic compiler_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay,
                            std::string const &mode) {
  if (auto missing = did_not_start(command, result)) return *missing;
  Diagnostic diagnostic{DiagnosticId::build_failed, {}, ""};
  std::vector<std::string> const output = lines_of(result.output);
  std::vector<Line> const lines = read_lines(output, overlay);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::optional<MessageLine> const &message = lines[i].message;
    std::optional<std::string> const error = lines[i].error();
    if (!message || !error || diagnostic.notes.size() > most_notes) continue;
    Place const &place = message->place;
    std::optional<Note> cause;
    if (!overlay.contains(place.file)) {
      cause = expansion(lines, i, overlay);
      if (!cause) cause = instantiation(lines, i, overlay);
    }
    if (diagnostic.message.empty()) {
      diagnostic.place = cause ? cause->place : place;
      diagnostic.message = *error;
      if (cause)
        diagnostic.notes.push_back({place, "the compiler stopped here"});
      else
        diagnostic.notes = instantiations(lines, i);
    } else {
      diagnostic.notes.push_back({cause ? cause->place : place, *error});
    }
  }
  if (!diagnostic.message.empty()) {
    diagnostic.message = "the program does not compile " + mode + ": " + diagnostic.message;
    return diagnostic;
  }
  diagnostic.message = "the compiler '" + command[0] + "' failed";
  diagnostic.notes = first_lines(output);
  return diagnostic;
}

// Parses [LINKER: ]FILE:LINE: undefined reference to `...', which linkers print if there is debug information.
Diagnostic linker_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay) {
  if (auto missing = did_not_start(command, result)) return *missing;
  constexpr std::string_view undefined = "undefined reference to ";
  Diagnostic diagnostic{DiagnosticId::link_failed, {}, "the symbolic program cannot be linked"};
  std::vector<std::string> const lines = lines_of(result.output);
  for (std::string const &line : lines) {
    std::size_t const at = line.find(undefined);
    if (at == line.npos) continue;
    std::size_t const linker = line.find("ld: ");
    std::size_t const begin = linker < at ? linker + 4 : 0;
    std::optional<MessageLine> const message = message_line(std::string_view(line).substr(begin, at - begin));
    bool const has_place = message && message->place.line != 0;
    Note const note{has_place ? overlay.original({message->place.file, message->place.line, 0}) : Place(),
                    line.substr(at)};
    if (diagnostic.place.file.empty() && diagnostic.notes.empty()) {
      diagnostic.place = note.place;
      diagnostic.message = note.message;
    } else if (diagnostic.notes.size() < most_notes) {
      diagnostic.notes.push_back(note);
    }
  }
  if (diagnostic.place.file.empty() && diagnostic.notes.empty()) diagnostic.notes = first_lines(lines);
  return diagnostic;
}

} // namespace symreal::program
