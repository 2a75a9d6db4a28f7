#include "program/events.h"

#include <charconv>
#include <fstream>
#include <string_view>

namespace symreal::program {
namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t end = 0; end != text.npos;) {
    end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end != text.npos) text.remove_prefix(end + 1);
  }
  return parts;
}

template <class T> T number(std::string_view text, int base = 10) {
  if (base == 16 && text.starts_with("0x")) text.remove_prefix(2);
  T value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, base);
  return value;
}

void add(Events &events, std::vector<std::string> const &field) {
  std::string const &kind = field[0];
  auto has = [&field](std::size_t count) { return field.size() >= count; };
  if (kind == "started" && has(2)) events.started.push_back(field[1]);
  if (kind == "kernel" && has(4)) events.kernels.push_back({field[1], field[2], field[3]});
  if (kind == "frozen" && has(5)) events.frozen.push_back({field[1], field[2], field[3], field[4]});
  if (kind == "diagnostic" && has(6)) {
    DiagnosticInfo const *row = find_diagnostic(field[1]);
    internal_check(row);
    Place place{field[2], number<unsigned>(field[3]), number<unsigned>(field[4])};
    events.diagnostics.push_back({row->id, Severity::error, place, field[5]});
  }
  if (kind == "decision" && has(4)) {
    Decision decision{number<std::size_t>(field[1]), field[2], {}};
    for (std::string const &address : split(field[3], ','))
      decision.addresses.push_back(number<std::uint64_t>(address, 16));
    events.decisions.push_back(decision);
  }
}

} // namespace

Events read_events(std::string const &path) {
  Events events;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) add(events, split(line, '\t'));
  return events;
}

} // namespace symreal::program
