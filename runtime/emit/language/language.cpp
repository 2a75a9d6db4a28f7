#include "emit/language/language.h"

#include "emit/language/pattern.h"
#include "support/number.h"

#include <algorithm>
#include <cmath>

namespace symreal {

std::string constant(Language const &language, double value) {
  NumberSyntax const &syntax = language.numbers;
  if (std::isnan(value)) return std::string(std::signbit(value) ? syntax.negative_nan : syntax.nan);
  if (std::isinf(value)) return std::string(value < 0 ? syntax.negative_infinity : syntax.infinity);
  std::string text = shortest(value);
  std::size_t const exponent = text.find('e');
  if (exponent != text.npos) return text.replace(exponent, 1, syntax.exponent);
  if (text.find('.') == text.npos) text += ".0";
  return text += syntax.suffix;
}

std::string comment(Language const &language, std::vector<std::string> const &lines, bool closed_apart) {
  auto const &[open, next, close] = language.comment;
  std::string text;
  for (std::string const &line : lines) text.append(text.empty() ? open : next).append(line) += '\n';
  text.pop_back();
  if (closed_apart && !close.empty()) text += "\n";
  return text += closed_apart ? close.substr(std::min(close.size(), close.find_first_not_of(' '))) : close;
}

std::string element(Language const &language, std::string_view array, std::size_t index) {
  ExpressionSyntax const &syntax = language.expressions;
  return fill(syntax.element, {{"array", array}, {"index", std::to_string(index + syntax.first_index)}});
}

} // namespace symreal
