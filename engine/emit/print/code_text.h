// Generated lines: their layout, and the source locations of their statements.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Source locations of a statement, and its comment on them; without a comment if empty.
struct Origin {
  std::vector<LocationId> locations;
  std::string comment;
};

class CodeText {
public:
  explicit CodeText(Language const &language) : language_(&language) {}

  // Prints a statement, broken at blanks to keep lines readable; it must not have string literals. An empty one prints
  // nothing. `indent`: 2 per enclosing block.
  void statement(std::size_t indent, std::string_view text, Origin origin = {});
  // Prints whole lines unchanged, each with its newline.
  void lines(std::string_view text);
  void append(CodeText &&other);
  // Reserves memory for this many characters; pages that are not written cost nothing.
  void reserve(std::size_t characters) { text_.reserve(text_.size() + characters); }
  std::size_t size() const { return text_.size(); }

  std::string take_text() { return std::move(text_); }
  std::vector<LineOrigin> take_origins() { return std::move(origins_); }

private:
  void end_line();

  Language const *language_;
  std::string text_;
  std::size_t line_ = 1; // number of the next line
  std::vector<LineOrigin> origins_;
};

// The values of a list, several per line.
std::string lines_of(Language const &language, std::vector<std::string> const &values);

// Text indented for its place between the functions of a file.
std::string indented(Language const &language, std::string const &text);

} // namespace symreal
