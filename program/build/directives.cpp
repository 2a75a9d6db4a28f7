#include "program/build/directives.h"

#include "rewrite/text/source_text.h"

#include <cctype>

namespace symreal::program {
namespace {

using rewrite::is_word;

class Reader {
public:
  explicit Reader(std::string const &text) : text_(text) {}

  Directives read() {
    while (at_ < text_.size()) step();
    return std::move(found_);
  }

private:
  bool is_at(char const *what) const { return text_.compare(at_, std::char_traits<char>::length(what), what) == 0; }

  void step() {
    char const c = text_[at_];
    if (is_at("/*"))
      at_ = past(text_.find("*/", at_ + 2), 2);
    else if (is_at("//"))
      at_ = end_of_line(at_);
    else if (is_at("\\\n"))
      at_ += 2;
    else if (c == '\n')
      new_line();
    else if (std::isspace(static_cast<unsigned char>(c)))
      ++at_;
    else if (c == '#' && is_first_)
      directive();
    else
      token();
  }

  void new_line() {
    is_first_ = true;
    is_directive_ = false;
    ++at_;
  }

  void directive() {
    is_directive_ = true;
    is_first_ = false;
    found_.directives.push_back({at_++, {}, {}});
  }

  void token() {
    is_first_ = false;
    char const c = text_[at_];
    Directive *const here = is_directive_ ? &found_.directives.back() : nullptr;
    bool const is_file = here && (here->keyword == "include" || here->keyword == "include_next");
    if (c == '"' || c == '\'' || (c == '<' && is_file)) return literal(c == '<' ? '>' : c);
    if (!is_word(c)) {
      ++at_;
      return;
    }
    Identifier word{at_, at_, {}};
    bool const is_number = std::isdigit(static_cast<unsigned char>(c)) != 0;
    while (at_ < text_.size() && (is_word(text_[at_]) || (is_number && text_[at_] == '.'))) ++at_;
    word.end = at_;
    word.text = text_.substr(word.begin, word.end - word.begin);
    if (is_number) return;
    if (here && here->keyword.empty()) {
      here->keyword = word.text;
      return;
    }
    if (here) here->identifiers.push_back(word);
    found_.identifiers.push_back(std::move(word));
  }

  // A literal ends with its line at the latest: text that is skipped may have a lone apostrophe.
  void literal(char end) {
    for (++at_; at_ < text_.size() && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\')
        ++at_;
      else if (text_[at_] == end) {
        ++at_;
        return;
      }
    }
  }

  std::size_t end_of_line(std::size_t at) const {
    std::size_t end = text_.find('\n', at);
    while (end != text_.npos && end > 0 && text_[end - 1] == '\\') end = text_.find('\n', end + 1);
    return end == text_.npos ? text_.size() : end;
  }

  std::size_t past(std::size_t at, std::size_t length) const { return at == text_.npos ? text_.size() : at + length; }

  std::string const &text_;
  std::size_t at_ = 0;
  bool is_first_ = true, is_directive_ = false;
  Directives found_;
};

} // namespace

Directives read_directives(std::string const &text) { return Reader(text).read(); }

} // namespace symreal::program
