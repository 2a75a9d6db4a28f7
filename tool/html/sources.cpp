#include "tool/html/sources.h"

#include "engine/support/files.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace symreal::tool {
namespace {

using rewrite::is_word;

// Collects the words of a declaration until its brace, its semicolon or another brace.
class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<FunctionLines> read() {
    while (at_ < text_.size())
      if (!skip_silent()) take();
    return std::move(found_);
  }

private:
  bool begins(std::string_view word) const { return text_.substr(at_).starts_with(word); }
  void skip_to(std::size_t end) {
    end = std::min(end, text_.size());
    line_ += static_cast<unsigned>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                              text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }
  std::size_t after(std::string_view word, std::size_t from) const {
    std::size_t const end = text_.find(word, from);
    return end == text_.npos ? end : end + word.size();
  }

  // Skips comments, directives and literals, whose braces do not count.
  bool skip_silent() {
    char const c = text_[at_];
    if (begins("//")) return skip_to(text_.find('\n', at_)), true;
    if (begins("/*")) return skip_to(after("*/", at_ + 2)), true;
    if (c == '#') return skip_to(end_of_directive()), true;
    if (begins("R\"(")) return skip_to(after(")\"", at_)), true;
    if (c == '"' || (c == '\'' && (at_ == 0 || !is_word(text_[at_ - 1])))) return skip_to(end_of_literal(c)), true;
    return false;
  }
  std::size_t end_of_directive() const {
    std::size_t end = text_.find('\n', at_);
    while (end != text_.npos && end != 0 && text_[end - 1] == '\\') end = text_.find('\n', end + 1);
    return end;
  }
  std::size_t end_of_literal(char mark) const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != mark && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
    return end + 1;
  }

  void take() {
    char const c = text_[at_];
    if (c == '{')
      open();
    else if (c == '}')
      close();
    else if (c == ';')
      declaration_.clear();
    else if (!std::isspace(static_cast<unsigned char>(c)) || !declaration_.ends_with(' '))
      add(std::isspace(static_cast<unsigned char>(c)) ? ' ' : c);
    skip_to(at_ + 1);
  }
  void add(char c) {
    if (declaration_.empty() || declaration_ == " ") first_ = line_;
    declaration_ += c;
  }

  void open() {
    if (depth_inside_ != 0) {
      ++depth_inside_;
    } else if (std::string name = function_name(); !name.empty()) {
      depth_inside_ = 1;
      found_.push_back({std::move(name), first_, line_});
    }
    declaration_.clear();
  }
  void close() {
    if (depth_inside_ != 0 && --depth_inside_ == 0) found_.back().last = line_;
    declaration_.clear();
  }

  // Name before the first parenthesis, if the declaration is the head of a function.
  std::string function_name() const {
    std::size_t const sign = declaration_.find("operator");
    if (sign != declaration_.npos && (sign == 0 || !is_word(declaration_[sign - 1]))) return operator_name(sign);
    std::size_t const open = declaration_.find('(');
    if (open == declaration_.npos || declaration_.substr(0, open).find('=') != declaration_.npos) return {};
    std::size_t end = open;
    while (end != 0 && declaration_[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin != 0 &&
           (is_word(declaration_[begin - 1]) || declaration_[begin - 1] == ':' || declaration_[begin - 1] == '~'))
      --begin;
    std::string const name = declaration_.substr(begin, end - begin);
    constexpr std::array no_functions{"if", "for", "while", "switch", "alignas", "__attribute__", "decltype"};
    return std::ranges::find(no_functions, name) == no_functions.end() ? name : std::string();
  }

  // Name of an operator function: "operator+", "operator()".
  std::string operator_name(std::size_t begin) const {
    std::size_t const open = declaration_.find('(', begin);
    if (open == declaration_.npos) return {};
    std::size_t end = declaration_.compare(open, 3, "()(") == 0 ? open + 2 : open;
    while (declaration_[end - 1] == ' ') --end;
    return declaration_.substr(begin, end - begin);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  unsigned line_ = 1, first_ = 1;
  std::size_t depth_inside_ = 0; // open braces within the function
  std::string declaration_;
  std::vector<FunctionLines> found_;
};

// Functions in text order, not nested. Reads braces, not C++: finds fewer functions if macros hide braces.
std::vector<FunctionLines> function_lines(std::string_view text) { return Reader(text).read(); }

std::optional<std::string> text_of(std::string const &file) {
  try {
    return read_file(file);
  } catch (DiagnosticError const &) {
    return {};
  }
}

} // namespace

Sources::Sources(Graph const &graph) {
  for (Location const &location : graph.locations)
    if (!location.places.empty()) numbers_[location.places.front().file];
  for (Frozen const &state : graph.frozen)
    if (!state.place.file.empty()) numbers_[state.place.file];
  for (auto &[name, number] : numbers_) {
    number = files_.size();
    files_.push_back({name, text_of(name), {}});
    auto &file = files_.back();
    if (file.text) file.functions = function_lines(*file.text);
  }
}

std::optional<std::size_t> Sources::number_of(std::string const &file) const {
  auto const found = numbers_.find(file);
  return found == numbers_.end() ? std::nullopt : std::optional(found->second);
}

std::string Sources::function_at(std::size_t file, unsigned line) const {
  std::vector<FunctionLines> const &functions = files_[file].functions;
  auto const next = std::ranges::upper_bound(functions, line, {}, &FunctionLines::first);
  return next != functions.begin() && std::prev(next)->last >= line ? std::prev(next)->name : std::string();
}

std::vector<Diagnostic> gone_sources(Sources const &sources) {
  std::vector<Diagnostic> warnings;
  for (SourceFile const &file : sources.files())
    if (!file.text)
      warnings.push_back({DiagnosticId::source_gone, {file.name}, "the report is without the text of this source"});
  return warnings;
}

} // namespace symreal::tool
