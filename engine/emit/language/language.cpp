#include "engine/emit/language/language.h"

#include "engine/emit/language/words.h"
#include "engine/support/number.h"

#include <algorithm>
#include <cmath>

namespace symreal {

Language in_single_precision(Language language) {
  internal_check(!language.single.number.name.empty());
  language.number = language.single.number;
  language.numbers = language.single.numbers;
  language.is_single = true;
  return language;
}

std::vector<std::pair<std::string_view, std::string_view>> words_of(Language const &language) {
  std::vector<std::pair<std::string_view, std::string_view>> words = {{"real", language.number.name},
                                                                      {"suffix", language.numbers.suffix}};
  for (Word const &word : language.words)
    words.emplace_back(word.name, language.is_single ? word.in_single : word.in_double);
  return words;
}

static std::optional<std::string_view> find_word(Language const &language, std::string_view name) {
  if (name == "real") return language.number.name;
  if (name == "suffix") return language.numbers.suffix;
  for (Word const &word : language.words)
    if (word.name == name) return language.is_single ? word.in_single : word.in_double;
  return std::nullopt;
}

std::string fill(Language const &language, std::string_view pattern,
                 std::initializer_list<std::pair<std::string_view, std::string_view>> values) {
  return fill_places(pattern, [&](std::string_view name) -> std::optional<std::string_view> {
    for (auto const &[given, value] : values)
      if (given == name) return value;
    return find_word(language, name);
  });
}

std::string with_words(Language const &language, std::string_view pattern) {
  std::string text;
  while (true) {
    std::size_t const dollar = std::min(pattern.find('$'), pattern.size());
    text += pattern.substr(0, dollar);
    if (dollar == pattern.size()) return text;
    pattern.remove_prefix(dollar + 1);
    std::size_t const length = length_of_name(pattern);
    std::optional<std::string_view> const word = find_word(language, pattern.substr(0, length));
    text += word.value_or("$");
    if (word) pattern.remove_prefix(length);
  }
}

std::string constant(Language const &language, double value) {
  NumberSyntax const &syntax = language.numbers;
  if (std::isnan(value)) return std::string(std::signbit(value) ? syntax.negative_nan : syntax.nan);
  if (std::isinf(value)) return std::string(value < 0 ? syntax.negative_infinity : syntax.infinity);
  if (value == 0 && std::signbit(value) && !syntax.negative_zero.empty()) return std::string(syntax.negative_zero);
  std::string text = language.is_single ? shortest(static_cast<float>(value)) : shortest(value);
  std::size_t const exponent = text.find('e');
  if (exponent != text.npos) return text.replace(exponent, 1, syntax.exponent).append(syntax.exponent_suffix);
  if (text.find('.') == text.npos) text += ".0";
  return text += syntax.suffix;
}

// A line of a comment with the comment's delimiter, such as *), split by a blank.
static std::string without(std::string line, std::string_view mark) {
  while (mark.starts_with(' ')) mark.remove_prefix(1);
  while (mark.ends_with(' ')) mark.remove_suffix(1);
  if (mark.size() != 2 || mark == "//") return line;
  for (std::size_t at = 0; (at = line.find(mark, at)) != line.npos;) line.insert(++at, " ");
  return line;
}

// A trailing backslash would continue the line, C replaces trigraphs, and Java reads \u anywhere.
static std::string commented(Language const &language, std::string const &line) {
  auto const &[open, next, close] = language.comment;
  std::string text = printable(line);
  for (std::string_view mark : {close, open, std::string_view("\\u"), std::string_view("??")})
    text = without(std::move(text), mark);
  if (text.ends_with('\\')) text += ' ';
  return text;
}

std::string comment(Language const &language, std::vector<std::string> const &lines, bool closed_apart) {
  auto const &[open, next, close] = language.comment;
  std::string text;
  for (std::string const &line : lines)
    text.append(text.empty() ? open : next).append(commented(language, line)) += '\n';
  text.pop_back();
  if (closed_apart && !close.empty()) text += "\n";
  return text += closed_apart ? close.substr(std::min(close.size(), close.find_first_not_of(' '))) : close;
}

std::string literal(Language const &language, std::string_view text) {
  StringSyntax const &syntax = language.strings;
  std::string result(syntax.quote);
  std::size_t length = 0;
  for (char const c : printable(text)) {
    if (syntax.most != 0 && ++length > syntax.most) {
      result.append(syntax.quote).append(syntax.joint).append(syntax.quote);
      length = 1;
    }
    bool const is_quote = syntax.quote.front() == c;
    if (syntax.doubles_quotes ? is_quote : syntax.escaped.find(c) != syntax.escaped.npos)
      result += syntax.doubles_quotes ? c : '\\';
    result += c;
  }
  return result.append(syntax.quote);
}

std::string element(Language const &language, std::string_view array, std::size_t index) {
  ExpressionSyntax const &syntax = language.expressions;
  return fill(language, syntax.element, {{"array", array}, {"index", std::to_string(index + syntax.first_index)}});
}

} // namespace symreal
