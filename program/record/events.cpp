#include "program/record/events.h"

#include <charconv>
#include <fstream>
#include <string_view>
#include <utility>

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

std::vector<std::uint64_t> addresses(std::string_view text) {
  std::vector<std::uint64_t> list;
  for (std::string const &address : split(text, ',')) list.push_back(number<std::uint64_t>(address, 16));
  return list;
}

DiagnosticInfo const &row(std::string const &code) {
  DiagnosticInfo const *found = find_diagnostic(code);
  internal_check(found);
  return *found;
}

void add(Events &events, std::vector<std::string> const &field) {
  std::string const &kind = field[0];
  auto has = [&field](std::size_t count) { return field.size() >= count; };
  if (kind == "started" && has(2)) events.started.push_back(field[1]);
  if (kind == "kernel" && has(4))
    events.kernels.push_back({field[1], field[2], field[3], events.started.empty() ? "" : events.started.back(),
                              std::exchange(events.scratch, {}), std::exchange(events.clauses, {})});
  if (kind == "clause" && has(3)) events.clauses[field[1]] = field[2];
  if (kind == "scratch" && has(2)) events.scratch.push_back(field[1]);
  if ((kind == "diagnostic" || kind == "warning") && has(6)) {
    Place place{field[2], number<unsigned>(field[3]), number<unsigned>(field[4])};
    Severity const severity = kind == "warning" ? Severity::warning : Severity::error;
    events.diagnostics.push_back({row(field[1]).id, place, field[5], {}, severity});
  }
  std::vector<Decision> *const decisions = kind == "decision"  ? &events.decisions
                                           : kind == "carried" ? &events.carried
                                           : kind == "settled" ? &events.settled
                                                               : nullptr;
  if (decisions && has(4)) decisions->push_back({number<std::size_t>(field[1]), field[2], addresses(field[3])});
  if (kind == "decided" && has(5))
    events.decided.push_back({number<std::uint32_t>(field[1]), field[2] == "t" || field[2] == "T" || field[2] == "Y",
                              std::string("TFYN").find(field[2]) != std::string::npos, field[2] == "j",
                              field[2] == "Y" || field[2] == "N", field[3], addresses(field[4])});
  if (kind == "joined" && has(5))
    events.joined.push_back({number<std::size_t>(field[1]), number<std::size_t>(field[2]),
                             number<std::size_t>(field[3]), number<std::size_t>(field[4])});
  if (kind == "in_vain" && has(2)) events.in_vain += number<std::size_t>(field[1]);
  if (kind == "join" && has(2)) events.joined_at.push_back(addresses(field[1]));
  if (kind == "undecided" && has(2)) events.undecided.push_back(number<std::size_t>(field[1]));
  if (kind == "followed" && has(2)) events.followed = number<std::size_t>(field[1]);
  if (kind == "beyond" && has(2)) events.beyond = number<std::size_t>(field[1]);
  events.is_cut_off = events.is_cut_off || kind == "cut";
  if (kind == "frozen" && has(6)) events.frozen.push_back({field[1], field[2], field[3], addresses(field[5])});
  if (kind == "met" && has(5))
    events.located.push_back({row(field[1]).id, field[2], addresses(field[3]), number<std::size_t>(field[4])});
  if (kind == "located" && has(4)) events.located.push_back({row(field[1]).id, field[2], addresses(field[3]), 0});
}

} // namespace

Events read_events(std::string const &path) {
  Events events;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) add(events, split(line, '\t'));
  return events;
}

std::vector<std::uint64_t> read_crash(std::string const &path) {
  std::ifstream in(path);
  std::string signal, list;
  in >> signal >> list;
  if (list.ends_with(',')) list.pop_back();
  return list.empty() ? std::vector<std::uint64_t>() : addresses(list);
}

} // namespace symreal::program
