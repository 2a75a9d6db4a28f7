#include "runtime/trace/report/events.h"

#include "engine/support/files.h"
#include "engine/support/mutation/is_dropped.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/report/call_stack.h"
#include "runtime/wire/request.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <unistd.h>

namespace symreal::trace {

namespace {

// Repeated reports, counted by place, in the order of their first occurrence.
class Meetings {
public:
  // Returns whether this is the first at the place.
  bool add(std::string const &condition, std::vector<std::uintptr_t> const &stack) {
    auto [found, is_new] = at_.try_emplace(stack);
    if (found->second.count++ != 0) return false;
    found->second.condition = condition;
    order_.push_back(found->first);
    return true;
  }
  template <class Print> void for_each(Print const &print) const {
    for (auto const &stack : order_) print(at_.at(stack).count, at_.at(stack).condition, stack);
  }

private:
  struct Meeting {
    std::size_t count = 0;
    std::string condition;
  };
  std::map<std::vector<std::uintptr_t>, Meeting> at_;
  std::vector<std::vector<std::uintptr_t>> order_;
};

struct Log {
  std::vector<std::string> lines;
  Meetings decisions, carried, settled;
  std::map<DiagnosticId, Meetings> interrupted;
  bool wrong = false, are_kept = false;
};

// Never destroyed: objects with static storage may record until the very end.
Log &log() {
  static Log *const instance = [] {
    std::atexit(flush_events);
    return memory::make_own<Log>();
  }();
  return *instance;
}

} // namespace

Place written_place(std::string_view place) {
  std::string text(place);
  unsigned numbers[2] = {0, 0};
  for (unsigned &number : numbers) {
    std::size_t const colon = text.rfind(':');
    if (colon == std::string::npos) return {text, 0, 0};
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
    text.resize(colon);
  }
  return {text, numbers[1], numbers[0]};
}

std::string const &record_directory() {
  static std::string const *const directory = [] {
    char const *text = wire::requested(wire::Entry::record);
    return new std::string(text ? text : "");
  }();
  return *directory;
}

void add_line(std::string line) { log().lines.push_back(std::move(line)); }

void report(Diagnostic const &diagnostic) {
  if (is_dropped(code(diagnostic.id))) return;
  bool const is_error = diagnostic.severity == Severity::error;
  log().wrong = log().wrong || is_error;
  auto const &[file, line, column] = diagnostic.place;
  if (is_error)
    event(events::Error{code(diagnostic.id), file, line, column, diagnostic.message});
  else
    event(events::Warning{code(diagnostic.id), file, line, column, diagnostic.message});
  if (record_directory().empty()) print(std::cerr, diagnostic);
}

void report_here(DiagnosticId id, std::string const &message) {
  memory::OwnWork const own;
  log().wrong = true;
  event(events::Located{code(id), message, call_stack()});
  if (record_directory().empty()) print(std::cerr, {id, {}, message});
}

void report_interrupted(DiagnosticId id, std::string const &message, std::uintptr_t delayed) {
  memory::OwnWork const own;
  log().wrong = true;
  if (log().interrupted[id].add(message, interrupted_stack(delayed)) && record_directory().empty())
    print(std::cerr, {id, {}, message});
}

void report_decision(std::string const &condition) {
  memory::OwnWork const own;
  if (log().decisions.add(condition, call_stack()) && record_directory().empty())
    std::cerr << "symreal: a decision on " << condition << "; symreal generate tells where\n";
  log().wrong = true;
}

void report_carried(std::string const &condition) {
  memory::OwnWork const own;
  log().carried.add(condition, call_stack());
}

void report_settled(std::string const &condition) {
  memory::OwnWork const own;
  log().settled.add(condition, call_stack());
}

bool anything_wrong() { return log().wrong; }

void keep_events(bool are_kept) { log().are_kept = are_kept; }

std::size_t told() {
  std::size_t count = log().lines.size();
  auto const add = [&count](std::size_t met, auto const &...) { count += met; };
  log().decisions.for_each(add);
  log().carried.for_each(add);
  for (auto const &interrupted : log().interrupted) interrupted.second.for_each(add);
  return count;
}

bool has_told(std::string_view event) {
  return std::ranges::any_of(log().lines,
                             [&](std::string const &line) { return wire::LineReader(line).word() == event; });
}

void flush_events() {
  memory::OwnWork const own;
  if (record_directory().empty() || log().are_kept) return;
  std::string text;
  for (std::string const &line : log().lines) text += line + '\n';
  auto const append = [&text]<class Event>(Event one, Meetings const &meetings) {
    meetings.for_each([&](std::size_t count, std::string const &condition, auto const &stack) {
      one.count = count;
      one.condition = condition;
      one.stack = stack;
      text += wire::line_of(one) + '\n';
    });
  };
  append(events::Decision(), log().decisions);
  append(events::Carried(), log().carried);
  append(events::Settled(), log().settled);
  for (auto const &interrupted : log().interrupted)
    interrupted.second.for_each([&](std::size_t count, std::string const &message, auto const &stack) {
      text += wire::line_of(events::Met{code(interrupted.first), message, stack, count}) + '\n';
    });
  try {
    write_if_changed(record_directory() + "/events", text);
  } catch (DiagnosticError const &error) {
    print(std::cerr, error.diagnostic());
  }
}

void give_up() {
  flush_events();
  std::fflush(nullptr);
  _exit(1);
}

} // namespace symreal::trace
