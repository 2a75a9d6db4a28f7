// Tokeniser for one line of a graph's text form. Internal to the readers of graph_text.h.
#pragma once

#include "engine/graph/graph.h"
#include "engine/support/number.h"
#include "engine/support/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Parses the whole text as a nonnegative integer; nullopt if it is invalid or out of range.
template <class Number = std::uint32_t> std::optional<Number> parse_natural(std::string_view text) {
  Number value = 0;
  auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  return failed == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

// The words of one line. A quoted string is one word, which keeps its opening quote as a mark.
class Line {
public:
  // If `place` lacks a column, errors have the column of the last word read.
  Line(std::string_view text, Place place) : place_(std::move(place)) {
    words_.reserve(8); // enough for a node
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] == ';') break;
      if (text[i] == ' ' || text[i] == '\t' || text[i] == '\r') {
        ++i;
        continue;
      }
      std::size_t const column = i + 1;
      std::string word(1, text[i++]);
      if (word[0] == '"') {
        while (i < text.size() && text[i] != '"') {
          if (text[i] == '\\' && i + 1 < text.size()) ++i;
          word += text[i++];
        }
        if (i++ >= text.size()) fail_at(column, "a string is not closed");
      } else {
        std::size_t const end = std::min(text.find_first_of(" \t\r;", i), text.size());
        word.append(text, i, end - i);
        i = end;
      }
      words_.push_back({std::move(word), column});
    }
  }

  bool done() const { return next_ == words_.size(); }
  std::string const &peek() const { return words_[next_].text; }
  bool accept(std::string_view word) {
    if (done() || peek() != word) return false;
    ++next_;
    return true;
  }
  std::string const &word(char const *what) {
    if (done()) error(std::string(what) + " is missing");
    return words_[next_++].text;
  }
  std::string string(char const *what) {
    std::string const &text = word(what);
    if (text[0] != '"') error(std::string(what) + " must stand in quotes");
    return text.substr(1);
  }
  std::uint32_t count(char const *what) {
    std::string const &text = word(what);
    std::optional<std::uint32_t> const value = parse_natural(text);
    if (!value) error("'" + text + "' is not valid as " + what);
    return *value;
  }
  double number(char const *what) {
    std::string const &text = word(what);
    auto value = parse_number(text);
    if (!value) error("'" + text + "' is not a number");
    return *value;
  }
  // Parses: at "file" line column; an empty place if absent.
  Place optional_place() {
    if (!accept("at")) return {};
    std::string file = string("the file");
    unsigned number = count("line number");
    return {std::move(file), number, count("column")};
  }
  // Parses: [n] [m] ...
  std::vector<std::size_t> extents() {
    std::vector<std::size_t> result;
    while (!done() && peek()[0] == '[') {
      std::string const &text = word("extent");
      std::optional<std::uint32_t> const extent = parse_natural(std::string_view(text).substr(1, text.size() - 2));
      if (text.back() != ']' || !extent) error("'" + text + "' is not an extent");
      result.push_back(*extent);
    }
    return result;
  }
  [[noreturn]] void error(std::string const &message) const {
    fail_at(words_.empty() ? 0 : words_[next_ == 0 ? 0 : next_ - 1].column, message);
  }
  // Error at the next, unread word.
  [[noreturn]] void unexpected() const {
    fail_at(words_[next_].column, "'" + words_[next_].text + "' is unexpected here");
  }

private:
  struct Word {
    std::string text;
    std::size_t column;
  };

  [[noreturn]] void fail_at(std::size_t column, std::string const &message) const {
    Place place = place_;
    if (place.column == 0) place.column = static_cast<unsigned>(column);
    fail(DiagnosticId::graph_syntax, place, message);
  }

  Place place_;
  std::vector<Word> words_;
  std::size_t next_ = 0;
};

// Kinds of values of an external function, as words, in the order of ExternalValue::Kind.
inline constexpr std::array<std::string_view, 7> kind_names = {"",       "number",  "integer", "input",
                                                               "output", "updated", "object"};

// Reads the line `external` (graph_reader.cpp), after its first word; these lines have ascending numbers.
void read_external(Line &line, std::vector<External> &externals);

} // namespace symreal
