#include "runtime/wire/event.h"

#include <charconv>

namespace symreal::wire {
namespace {

template <class T> T number(std::string_view text, int base) {
  T value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, base);
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; end != text.npos;) {
    end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end != text.npos) text.remove_prefix(end + 1);
  }
  return parts;
}

} // namespace

void LineWriter::operator()(Text const &text) {
  line_ += '\t';
  for (char c : text) line_ += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
}

void LineWriter::operator()(Number number) { line_.append("\t").append(std::to_string(number)); }

void LineWriter::operator()(Stack const &stack) {
  char separator = '\t';
  if (stack.empty()) line_ += separator;
  for (std::uintptr_t address : stack) {
    char digits[2 * sizeof address];
    char *const end = std::to_chars(std::begin(digits), std::end(digits), address, 16).ptr;
    line_ += separator;
    line_.append(digits, end);
    separator = ',';
  }
}

LineReader::LineReader(std::string_view line) : fields_(split(line, '\t')) {}

void LineReader::operator()(Number &number) { number = wire::number<Number>(fields_[++read_], 10); }

void LineReader::operator()(Stack &stack) { stack = read_stack(fields_[++read_]); }

Stack read_stack(std::string_view text) {
  Stack stack;
  for (std::string_view address : split(text, ',')) stack.push_back(number<std::uintptr_t>(address, 16));
  return stack;
}

} // namespace symreal::wire
