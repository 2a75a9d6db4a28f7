#include "engine/emit/language/toml.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <set>
#include <stdexcept>

namespace symreal {

void table_fault(std::string_view file, unsigned line, std::string const &what) {
  throw std::runtime_error(fmt::format("{}:{}: {}", file, line, what));
}

namespace {

class TomlReader {
public:
  TomlReader(std::string_view file, std::string_view text) : file_(file), text_(text) {}

  std::vector<TomlEntry> read() {
    for (skip(true); !text_.empty(); skip(true)) {
      if (text_.starts_with('['))
        read_header();
      else
        read_entry(table_);
      skip(false);
      if (!text_.empty() && !text_.starts_with('\n')) fault("the line goes on behind the value");
    }
    return std::move(entries_);
  }

private:
  [[noreturn]] void fault(std::string const &what) const { table_fault(file_, line_, what); }

  void take(std::size_t count) {
    line_ += static_cast<unsigned>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(count), '\n'));
    text_.remove_prefix(count);
  }
  bool took(std::string_view token) {
    if (!text_.starts_with(token)) return false;
    take(token.size());
    return true;
  }
  void expect(std::string_view token) {
    if (!took(token)) fault(fmt::format("'{}' is missing", token));
  }

  // Blanks and comments, and the ends of lines where a value or a list goes on.
  void skip(bool over_lines) {
    while (!text_.empty()) {
      if (text_[0] == '#')
        take(std::min(text_.find('\n'), text_.size()));
      else if (text_[0] == ' ' || text_[0] == '\t' || (over_lines && text_[0] == '\n'))
        take(1);
      else
        return;
    }
  }

  std::string_view taken(std::size_t count) {
    std::string_view const part = text_.substr(0, count);
    take(count);
    return part;
  }

  std::string read_key() {
    std::string key;
    do {
      skip(false);
      if (!key.empty()) key += '.';
      constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
      std::size_t const length = std::min(text_.find_first_not_of(letters), text_.size());
      if (length == 0 && !text_.starts_with('"') && !text_.starts_with('\'')) fault("a key is missing");
      key += length == 0 ? read_text() : taken(length);
      skip(false);
    } while (took("."));
    return key;
  }

  void read_header() {
    expect("[");
    table_ = read_key() + '.';
    expect("]");
  }

  void read_entry(std::string const &table) {
    std::string const path = table + read_key();
    unsigned const line = line_;
    expect("=");
    skip(false);
    if (took("{")) {
      for (skip(false); !took("}"); skip(false)) {
        read_entry(path + ".");
        skip(false);
        if (!took(",") && !text_.starts_with('}')) fault("'}' is missing");
      }
      return;
    }
    if (!paths_.insert(path).second) fault(fmt::format("'{}' is given twice", path));
    entries_.push_back({path, read_value(), file_, line});
  }

  TomlValue read_value() {
    if (text_.starts_with('"') || text_.starts_with('\'')) return {read_text()};
    if (took("true")) return {true};
    if (took("false")) return {false};
    if (took("[")) {
      TomlValue::List list;
      for (skip(true); !took("]"); skip(true)) {
        list.push_back(read_value());
        skip(true);
        if (!took(",") && !text_.starts_with(']')) fault("']' is missing");
      }
      return {std::move(list)};
    }
    std::int64_t number = 0;
    auto const [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), number);
    if (error != std::errc()) fault("neither a text in quotation marks nor a number, true, false or a list");
    take(static_cast<std::size_t>(end - text_.data()));
    return {number};
  }

  std::string read_text() {
    bool const is_literal = text_[0] == '\'';
    for (std::string_view const mark : is_literal ? std::array{"'''", "'"} : std::array{"\"\"\"", "\""})
      if (took(mark)) return read_text(mark, is_literal);
    return {};
  }

  std::string read_text(std::string_view mark, bool is_literal) {
    bool const has_lines = mark.size() == 3;
    if (has_lines) took("\n");
    std::string text;
    while (!took(mark)) {
      if (text_.empty() || (!has_lines && text_[0] == '\n')) fault("the text does not end");
      if (is_literal || !took("\\")) {
        text += taken(1);
        continue;
      }
      constexpr std::string_view escapes = "\"\\nt", meanings = "\"\\\n\t";
      std::size_t const escape = escapes.find(taken(1));
      if (escape == escapes.npos) fault("a backslash stands before \\, \", n or t only");
      text += meanings[escape];
    }
    return text;
  }

  std::string_view file_, text_;
  unsigned line_ = 1;
  std::string table_;
  std::set<std::string> paths_;
  std::vector<TomlEntry> entries_;
};

} // namespace

std::vector<TomlEntry> read_toml(std::string_view file, std::string_view text) { return TomlReader(file, text).read(); }

} // namespace symreal
