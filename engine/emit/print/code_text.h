// Generated lines, with the source places of their statements.
#pragma once

#include "engine/emit/language/emitted.h"
#include "engine/emit/language/language.h"

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Where a statement comes from, and what its comment says of that; empty: no comment.
struct Origin {
  std::vector<LocationId> locations;
  std::string comment;
};

class CodeText {
public:
  explicit CodeText(Language const &language) : language_(&language) {}

  // A statement, broken at blanks so that lines stay readable; it has no string literals. Nothing, if it is empty.
  // `indent`: 2 for each block around it.
  void statement(std::size_t indent, std::string_view text, Origin origin = {});
  // Whole lines as they are, each with its newline.
  void lines(std::string_view text);
  void append(CodeText &&other);
  // So many characters will follow; memory that is not written costs nothing.
  void reserve(std::size_t characters) { text_.reserve(text_.size() + characters); }
  std::size_t size() const { return text_.size(); }

  std::string take_text() { return std::move(text_); }
  std::vector<LineOrigin> take_origins() { return std::move(origins_); }

private:
  void end_line();

  Language const *language_;
  std::string text_;
  std::size_t line_ = 1; // that is written next
  std::vector<LineOrigin> origins_;
};

} // namespace symreal
