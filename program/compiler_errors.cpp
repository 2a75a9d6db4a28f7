#include "program/compiler_errors.h"

#include <cstring>
#include <optional>
#include <regex>
#include <sstream>

namespace symreal::program {
namespace {

constexpr std::size_t most_notes = 4;

struct Message {
  Place place;
  std::string text;
};

std::vector<std::string> lines_of(std::string const &output) {
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::optional<Message> match(std::string const &line, std::regex const &pattern, Overlay const &overlay) {
  std::smatch found;
  if (line.size() > 2000 || !std::regex_match(line, found, pattern)) return {};
  Place place{found[1], static_cast<unsigned>(std::stoul(found[2])), 0};
  if (found[3].matched) place.column = static_cast<unsigned>(std::stoul(found[3]));
  return Message{overlay.original(place), found[4]};
}

// The last line of the user's own before `end` that says from where a template was instantiated.
std::optional<Message> instantiation(std::vector<std::string> const &lines, std::size_t end, Overlay const &overlay) {
  static std::regex const required("([^:]+):([0-9]+):(?:([0-9]+):)? +(required from.*|in instantiation of.*)");
  for (std::size_t i = end; i-- > 0 && end - i < 40;)
    if (auto message = match(lines[i], required, overlay); message && overlay.contains(message->place.file))
      return message;
  return {};
}

// In which instantiation the error in line `at` stands: gcc says so before it, clang after it.
std::vector<Note> instantiations(std::vector<std::string> const &lines, std::size_t at, Overlay const &overlay) {
  static std::regex const required("([^:]+):([0-9]+):(?:([0-9]+):)? +(required (?:from|by) .*)");
  static std::regex const requested("([^:]+):([0-9]+):(?:([0-9]+):)? note: (in instantiation of .*)");
  std::vector<Note> notes;
  for (std::size_t i = at; i-- > 0 && notes.size() < most_notes;) {
    auto const message = match(lines[i], required, overlay);
    if (!message) break;
    notes.insert(notes.begin(), {message->place, message->text});
  }
  for (std::size_t i = at + 1; i < lines.size() && lines[i].find(" error: ") == std::string::npos; ++i)
    if (auto const message = match(lines[i], requested, overlay); message && notes.size() < most_notes)
      notes.push_back({message->place, message->text});
  return notes;
}

// The last line of the user's own after `begin` that says which macro the error stands in: ours stand in a header.
std::optional<Message> expansion(std::vector<std::string> const &lines, std::size_t begin, Overlay const &overlay) {
  static std::regex const expanded("([^:]+):([0-9]+):(?:([0-9]+):)? note: (in (?:definition|expansion) of macro .*)");
  std::optional<Message> last;
  for (std::size_t i = begin + 1; i < lines.size() && lines[i].find(" error: ") == std::string::npos; ++i)
    if (auto message = match(lines[i], expanded, overlay); message && overlay.contains(message->place.file))
      last = message;
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

Diagnostic compiler_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay,
                            std::string const &mode) {
  if (auto missing = did_not_start(command, result)) return *missing;
  static std::regex const error("([^:]+):([0-9]+):(?:([0-9]+):)? (?:fatal error|error): (.*)");
  Diagnostic diagnostic{DiagnosticId::build_failed, {}, ""};
  std::vector<std::string> lines = lines_of(result.output);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto message = match(lines[i], error, overlay);
    if (!message || diagnostic.notes.size() > most_notes) continue;
    std::optional<Message> cause;
    if (!overlay.contains(message->place.file)) {
      cause = expansion(lines, i, overlay);
      if (!cause) cause = instantiation(lines, i, overlay);
    }
    if (diagnostic.message.empty()) {
      diagnostic.place = cause ? cause->place : message->place;
      diagnostic.message = message->text;
      if (cause)
        diagnostic.notes.push_back({message->place, "the compiler stopped here"});
      else
        diagnostic.notes = instantiations(lines, i, overlay);
    } else {
      diagnostic.notes.push_back({cause ? cause->place : message->place, message->text});
    }
  }
  if (!diagnostic.message.empty()) {
    diagnostic.message = "the program does not compile " + mode + ": " + diagnostic.message;
    return diagnostic;
  }
  diagnostic.message = "the compiler '" + command[0] + "' failed";
  diagnostic.notes = first_lines(lines);
  return diagnostic;
}

Diagnostic linker_failure(std::vector<std::string> const &command, Captured const &result, Overlay const &overlay) {
  if (auto missing = did_not_start(command, result)) return *missing;
  // With debug information the linker names the source: file:line: undefined reference to `...'
  static std::regex const undefined(
      "(?:[^ ]*/?ld: )?(?:([^:]+):([0-9]+):|[^`]*:)?(?:\\(.*\\):)? *(undefined reference to .*)");
  Diagnostic diagnostic{DiagnosticId::link_failed, {}, "the symbolic program cannot be linked"};
  std::vector<std::string> lines = lines_of(result.output);
  for (std::string const &line : lines) {
    std::smatch found;
    if (line.size() > 2000 || !std::regex_match(line, found, undefined)) continue;
    Place place;
    if (found[1].matched) place = overlay.original({found[1], static_cast<unsigned>(std::stoul(found[2])), 0});
    if (diagnostic.place.file.empty() && diagnostic.notes.empty()) {
      diagnostic.place = place;
      diagnostic.message = found[3];
    } else if (diagnostic.notes.size() < most_notes) {
      diagnostic.notes.push_back({place, found[3]});
    }
  }
  if (diagnostic.place.file.empty() && diagnostic.notes.empty()) diagnostic.notes = first_lines(lines);
  return diagnostic;
}

} // namespace symreal::program
