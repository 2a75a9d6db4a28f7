#include "engine/emit/print/code_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace symreal {

void CodeText::end_line() {
  text_ += '\n';
  ++line_;
}

void CodeText::statement(std::size_t indent, std::string_view text, Origin origin) {
  if (text.empty()) return;
  LineLimits const &limits = language_->lines;
  indent = limits.base + indent / 2 * limits.step;
  std::size_t const first_line = line_, width = std::max(limits.width, indent + limits.least), first_indent = indent;
  std::size_t const mark = limits.continuation.size();
  while (true) {
    text_.append(indent, ' ');
    if (text.size() + indent <= width) break;
    std::size_t cut = text.rfind(' ', width - indent - mark);
    if (cut == text.npos || cut == 0) cut = text.find(' ');
    if (cut == text.npos) break;
    text_.append(text.substr(0, cut)).append(limits.continuation);
    end_line();
    text.remove_prefix(cut + 1);
    indent = first_indent + 2 * limits.step;
  }
  text_.append(text);
  if (!origin.comment.empty()) {
    // A comment follows its statement if at least the numbers of its locations fit, else on a line of its own.
    std::size_t const room = fmt::format(" /*@{}*/", fmt::join(origin.locations, ",")).size();
    if (indent + text.size() + room > width) end_line();
    text_ += " " + symreal::comment(*language_, {origin.comment});
  }
  end_line();
  if (!origin.locations.empty()) origins_.push_back({first_line, line_ - 1, std::move(origin.locations)});
}

void CodeText::lines(std::string_view text) {
  text_.append(text);
  line_ += static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

void CodeText::append(CodeText &&other) {
  for (LineOrigin &origin : other.origins_)
    origins_.push_back({origin.first_line + line_ - 1, origin.last_line + line_ - 1, std::move(origin.locations)});
  if (other.text_.size() > text_.size()) { // avoids moving the longer text
    other.text_.insert(0, text_);
    std::swap(text_, other.text_);
  } else {
    text_.append(other.text_);
  }
  line_ += other.line_ - 1;
  other = CodeText(*language_);
}

std::string lines_of(Language const &language, std::vector<std::string> const &values) {
  std::string text;
  std::size_t width = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    bool const breaks = k == 0 || width + values[k].size() > 80;
    if (k != 0) text += breaks ? "," : ", ";
    if (breaks) text += std::string(language.lines.continuation) + "\n    ";
    width = (breaks ? 0 : width) + values[k].size() + 2;
    text += values[k];
  }
  return text;
}

std::string indented(Language const &language, std::string const &text) {
  if (language.module.indent == 0) return text;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t const end = std::min(text.find('\n', at), text.size() - 1);
    if (end != at) result.append(language.module.indent, ' ');
    result += text.substr(at, end - at + 1);
    at = end + 1;
  }
  return result;
}

} // namespace symreal
