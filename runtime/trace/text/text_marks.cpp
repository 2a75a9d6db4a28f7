#include "runtime/trace/text/text_marks.h"

#include "engine/support/text.h"
#include "runtime/memory/own_memory.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <symreal/standard_library.h>

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <sys/stat.h>

namespace symreal {

__thread detail::Shown detail::shown = {};

namespace trace {

namespace {

constexpr std::size_t shortest_in_text = 3;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Calls `found` with each number in the text, without its sign.
template <class Found> void each_number(std::string_view text, Found found) {
  for (std::size_t at = 0; at < text.size();) {
    bool const begins = is_digit(text[at]) || (text[at] == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
    if (!begins) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
    if (end + 1 < text.size() && (text[end] == 'e' || text[end] == 'E')) {
      std::size_t exponent = end + 1;
      if (exponent + 1 < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
      if (is_digit(text[exponent])) {
        end = exponent;
        while (end < text.size() && is_digit(text[end])) ++end;
      }
    }
    found(text.substr(at, end - at));
    at = end;
  }
}

bool is_standard(std::ios const &stream) {
  return stream.rdbuf() == std::cout.rdbuf() || stream.rdbuf() == std::cerr.rdbuf() ||
         stream.rdbuf() == std::clog.rdbuf() || stream.rdbuf() == std::cin.rdbuf();
}

std::pair<std::uint64_t, std::uint64_t> inode(std::FILE *file) {
  struct stat status;
  if (fileno(file) < 0 || fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode)) return {0, 0};
  return {status.st_dev, status.st_ino};
}

} // namespace

void TextMarks::begin() {
  *this = {};
  detail::has_text = false;
  detail::shown = {};
}

void TextMarks::end() { begin(); }

void TextMarks::made(std::string_view text, RealNumber value) {
  detail::has_text = true;
  last_ = value;
  std::string_view const words = trimmed(text);
  std::size_t numbers = 0;
  each_number(words, [&](std::string_view number) {
    ++numbers;
    if (number.size() >= shortest_in_text) numbers_.emplace(number, value);
  });
  if (!words.empty()) texts_.emplace(words, value);
}

void TextMarks::made(char const *text, std::size_t size, RealNumber value) {
  made(std::string_view(text, size), value);
  drop_left();
  written_[text] = {std::string(text, size), value};
}

void TextMarks::made_file(std::FILE *file, RealNumber value) {
  detail::has_text = true;
  last_ = value;
  files_[file] = value;
  if (auto const number = inode(file); number.second != 0) inodes_[number] = value;
}

void TextMarks::made_stream(std::ios const &stream, RealNumber value) {
  detail::has_text = true;
  last_ = value;
  if (dynamic_cast<std::filebuf *>(stream.rdbuf())) in_some_file_ = value;
}

// Drops text in the frames of functions that have returned.
void TextMarks::drop_left() {
  auto const here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  std::erase_if(written_, [here](auto const &one) {
    return detail::on_own_stack(one.first) && reinterpret_cast<std::uintptr_t>(one.first) < here;
  });
}

// The number that was printed into this text and is unchanged since; 0 without one.
RealNumber TextMarks::value_at(char const *text, std::size_t size) {
  drop_left();
  for (auto at = written_.upper_bound(text + size - 1); at != written_.begin();) {
    --at;
    auto const &[begin, written] = *at;
    std::size_t const from = text > begin ? static_cast<std::size_t>(text - begin) : 0;
    for (std::size_t k = from; k < written.text.size() && begin + k < text + size; ++k)
      if (begin[k] == written.text[k]) return written.value;
  }
  return 0.0;
}

RealNumber TextMarks::value_said(std::string_view text) const {
  std::string_view const words = trimmed(text);
  if (auto const found = texts_.find(words); found != texts_.end()) return found->second;
  RealNumber value = 0.0;
  each_number(words, [&](std::string_view number) {
    if (number.size() < shortest_in_text || value.is_node()) return;
    auto const found = numbers_.lower_bound(number); // the whole of it, or its first digits
    if (found != numbers_.end() && found->first.starts_with(number)) value = found->second;
  });
  if (value.is_node()) return value;
  for (auto const &[part, of] : texts_)
    if (part.size() >= shortest_in_text && words.find(part) != words.npos) return of;
  return 0.0;
}

RealNumber TextMarks::value_in(char const *text, std::size_t size) {
  if (size == 0) return 0.0;
  RealNumber const value = value_at(text, size);
  return value.is_node() ? value : value_said({text, size});
}

void TextMarks::look(char const *text, std::size_t size) {
  if (RealNumber const value = value_in(text, size); value.is_node()) written_[text] = {std::string(text, size), value};
}

RealNumber TextMarks::value_in_file(std::FILE *file) {
  if (auto const found = files_.find(file); found != files_.end()) return found->second;
  auto const number = inode(file);
  if (auto const found = inodes_.find(number); number.second != 0 && found != inodes_.end()) return found->second;
  return number.second != 0 ? in_some_file_ : RealNumber(0.0);
}

RealNumber TextMarks::value_in_stream(std::ios const &stream) {
  if (auto const *text = dynamic_cast<std::stringbuf *>(stream.rdbuf())) return value_said(text->view());
  return is_standard(stream) ? RealNumber(0.0) : last_;
}

void TextMarks::report_read(std::string const &what, RealNumber value, char const *place) {
  if (!reported_.insert(place).second) return;
  report({DiagnosticId::text_read_back, written_place(place), what + " " + describe(value)});
}

static std::string quoted_name(char const *name) { return "'" + std::string(name) + "'"; }

} // namespace trace

namespace detail {

using trace::Pause;
using trace::session;

// The carried value, for text.
double shown_value(RealNumber x) noexcept {
  double const value = needed_value(x);
  if (recording) shown = {x.to_bits(), reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0))};
  return value;
}

static RealNumber number(Shown value) { return RealNumber::from_bits(value.number); }

static void length_used(Shown value, char const *used_at) {
  if (used_at)
    session().text_marks.report_read("the length that is used here is that of the text of", number(value), used_at);
}

void made_text(char const *text, std::size_t size, Shown value, char const *used_at) noexcept {
  Pause const pause;
  session().text_marks.made(text, size, number(value));
  length_used(value, used_at);
}

void made_file(std::FILE *file, Shown value) noexcept {
  if (!value.number) return;
  Pause const pause;
  session().text_marks.made_file(file, number(value));
}

void made_length(Shown value, char const *used_at) noexcept {
  Pause const pause;
  length_used(value, used_at);
}

void made_string(char const *text, std::size_t size, RealNumber value) noexcept {
  if (!recording || !value.is_node()) return;
  Pause const pause;
  session().text_marks.made({text, size}, value);
}

void made_list(RealNumber value, char const *format, std::va_list list) noexcept {
  std::va_list copy;
  va_copy(copy, list);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, copy)) + 1, '\0');
  va_end(copy);
  va_copy(copy, list);
  std::vsnprintf(text.data(), text.size(), format, copy);
  va_end(copy);
  made_string(text.c_str(), std::strlen(text.c_str()), value);
}

void made_printed(RealNumber value, char const *format, ...) noexcept {
  std::va_list list;
  va_start(list, format);
  made_list(value, format, list);
  va_end(list);
}

std::size_t hash(double number) noexcept { return std::hash<double>()(number); }

std::size_t print_number(RealNumber x, char (&text)[longest_number]) noexcept {
  double const number = x.is_node() ? needed_value(x) : x.plain();
  auto const size = static_cast<std::size_t>(std::snprintf(text, sizeof text, "%f", number));
  made_string(text, size, x);
  return size;
}

static void made_stream(std::ios const &stream, std::string_view text, RealNumber value) noexcept {
  if (!recording || !value.is_node() || trace::is_standard(stream)) return;
  Pause const pause;
  session().text_marks.made_stream(stream, value);
  session().text_marks.made(text, value);
}

void made_stream(std::ios const &stream, long long integer, RealNumber value) noexcept {
  made_stream(stream, std::to_string(integer), value);
}

Shown value_in(char const *text, std::size_t size) noexcept {
  Pause const pause;
  RealNumber const value = session().text_marks.value_in(text, size);
  return {value.is_node() ? value.to_bits() : 0, 0};
}

static void judge(RealNumber value, char const *name, char const *place) {
  if (value.is_node())
    session().text_marks.report_read(trace::quoted_name(name) + " is read, which holds the text of", value, place);
}

void read_character(char const *character, char const *name, char const *place) noexcept {
  Pause const pause;
  judge(session().text_marks.value_at(character, 1), name, place);
}

void read_text(char const *text, std::size_t size, char const *name, char const *place) noexcept {
  Pause const pause;
  if (!name)
    session().text_marks.look(text, size);
  else
    judge(session().text_marks.value_in(text, size), name, place);
}

void read_file(std::FILE *file, char const *name, char const *place) noexcept {
  Pause const pause;
  judge(session().text_marks.value_in_file(file), name, place);
}

void read_stream(std::ios const &stream, char const *name, char const *place) noexcept {
  Pause const pause;
  judge(session().text_marks.value_in_stream(stream), name, place);
}

} // namespace detail

namespace types {

std::ostream &operator<<(std::ostream &out, RealNumber x) {
  double const number = x.is_node() ? detail::needed_value(x) : x.plain();
  if (x.is_node() && detail::recording) {
    std::ostringstream text; // as it will read there
    text.copyfmt(out);
    text << number;
    detail::made_stream(out, text.view(), x);
  }
  return out << number;
}

std::ostream &operator<<(std::ostream &out, SymbolicBool x) {
  detail::made_stream(out, symreal_value(x) ? "1" : "0", x.condition());
  return out << symreal_value(x);
}

std::istream &operator>>(std::istream &in, RealNumber &x) {
  double number = 0;
  in >> number;
  x = number;
  return in;
}

} // namespace types
} // namespace symreal
