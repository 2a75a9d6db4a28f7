// Events that a recording reports to the tool, which event.def lists: lines of the file `events` in the directory
// `record` (request.def), a word and fields between tabs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::wire {

using Text = std::string; // tabs and ends of lines become blanks
using Number = std::uint64_t;
// Return addresses, innermost first, relative to where the executable is loaded.
using Stack = std::vector<std::uintptr_t>;

namespace events {
#define FIELD(type, name) type name = {};
#define EVENT(type, word, meaning, fields)                                                                             \
  struct type {                                                                                                        \
    static constexpr std::string_view name_of_event = #word;                                                           \
    fields                                                                                                             \
  };
#include "runtime/wire/event.def"
#undef EVENT
#undef FIELD
} // namespace events

// Calls `visit` with each field, in order.
#define FIELD(type, name) visit(event.name);
#define EVENT(type, word, meaning, fields)                                                                             \
  template <class Visit> void each_field([[maybe_unused]] events::type &event, [[maybe_unused]] Visit &&visit) {       \
    fields                                                                                                             \
  }
#include "runtime/wire/event.def"
#undef EVENT
#undef FIELD

class LineWriter {
public:
  explicit LineWriter(std::string_view word) : line_(word) {}
  void operator()(Text const &text);
  void operator()(Number number);
  void operator()(Stack const &stack);
  std::string const &line() const { return line_; }

private:
  std::string line_;
};

class LineReader {
public:
  explicit LineReader(std::string_view line);
  std::string_view word() const { return fields_[0]; }
  // Number of fields behind the word.
  std::size_t size() const { return fields_.size() - 1; }
  // Read the next field.
  void operator()(Text &text) { text = fields_[++read_]; }
  void operator()(Number &number);
  void operator()(Stack &stack);

private:
  std::vector<std::string_view> fields_;
  std::size_t read_ = 0;
};

template <class Event> std::string line_of(Event event) {
  LineWriter writer(Event::name_of_event);
  each_field(event, writer);
  return writer.line();
}

// Calls `receive` with the event of the line. Lines of other versions, with an unknown word or too few fields, are left
// out.
template <class Receive> void read_event(std::string_view line, Receive &&receive) {
  LineReader reader(line);
#define EVENT(type, word_of_event, meaning, fields)                                                                    \
  if (reader.word() == #word_of_event) {                                                                               \
    events::type event;                                                                                                \
    std::size_t wanted = 0;                                                                                            \
    each_field(event, [&wanted](auto const &) { ++wanted; });                                                          \
    if (reader.size() < wanted) return;                                                                                \
    each_field(event, reader);                                                                                         \
    return receive(event);                                                                                             \
  }
#include "runtime/wire/event.def"
#undef EVENT
}

// Addresses between commas, hexadecimal.
Stack read_stack(std::string_view text);

} // namespace symreal::wire
