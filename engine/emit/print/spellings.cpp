#include "engine/emit/print/spellings.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace symreal {

namespace {

// Parses a pattern such as "merge($y, $z, $x:4)".
std::vector<Spellings::Piece> parse(std::string_view pattern) {
  std::vector<Spellings::Piece> pieces;
  while (!pattern.empty()) {
    std::size_t const dollar = std::min(pattern.find('$'), pattern.size());
    if (dollar != 0) pieces.push_back({std::string(pattern.substr(0, dollar))});
    if (dollar == pattern.size()) break;
    internal_check(dollar + 1 < pattern.size());
    Spellings::Piece piece{{}, pattern[dollar + 1] - 'x'};
    internal_check(piece.operand >= 0 && piece.operand < 3);
    pattern.remove_prefix(dollar + 2);
    if (pattern.starts_with(':')) {
      auto const end = std::from_chars(pattern.data() + 1, pattern.data() + pattern.size(), piece.binding).ptr;
      pattern.remove_prefix(static_cast<std::size_t>(end - pattern.data()));
    }
    pieces.push_back(piece);
  }
  return pieces;
}

// The cast to the language's type of numbers: of "(double)(int8_t)" the first part is replaced.
std::string cast_of(Language const &language, std::string_view cast) {
  constexpr std::string_view to_double = "(double)";
  if (cast.starts_with(to_double)) cast.remove_prefix(to_double.size());
  return fmt::format("({}){}", language.number.name, cast);
}

// Pattern according to the operation table.
std::string usual_pattern(OperationInfo const &operation, Language const &language) {
  static constexpr std::string_view operands = "$x, $y, $z";
  int const precedence = operation.precedence;
  switch (operation.form) {
  case Form::local:
  case Form::call: {
    ExpressionSyntax const &syntax = language.expressions;
    bool const is_call = operation.form == Form::call;
    return fmt::format("{}{}{}{}{}{}", is_call ? syntax.call_prefix : syntax.local_prefix,
                       language.names.spelled(operation.c),
                       is_call && language.is_single ? language.single.call_suffix : "", syntax.call_open,
                       operands.substr(0, 4 * operation.arity - 2), syntax.call_close);
  }
  case Form::prefix: return fmt::format("{}$x:{}", operation.c, binding::prefix_operand);
  case Form::cast: return cast_of(language, operation.c) + "($x)";
  case Form::infix: {
    // Comparisons and logic are parenthesised when mixed: compilers warn, and readers stumble.
    bool const arithmetic = precedence >= binding::additive;
    std::string const blank = precedence > binding::additive ? "" : " ";
    return fmt::format("$x:{}{}{}{}$y:{}", arithmetic ? precedence : binding::additive, blank, operation.c, blank,
                       arithmetic ? precedence + 1 : binding::additive);
  }
  case Form::select: return fmt::format("$x:{0} ? $y:{0} : $z:{0}", binding::conditional_operand);
  case Form::external: break; // printed by separate code
  }
  return {};
}

} // namespace

Spellings::Spellings(Language const &language) {
  for (OperationInfo const &operation : operations())
    spellings_[static_cast<std::size_t>(operation.op)] = {parse(usual_pattern(operation, language)),
                                                          operation.precedence};
  for (OperationSpelling const &exception : language.expressions.operations)
    spellings_[static_cast<std::size_t>(exception.op)] = {parse(with_words(language, exception.pattern)),
                                                          exception.precedence};
  if (language.is_single) make_single(language);
}

// In single precision, rounding to float is the identity, and functions that return double get a cast.
void Spellings::make_single(Language const &language) {
  spellings_[static_cast<std::size_t>(Op::f32)] = {parse("($x)"), 0};
  if (language.single.narrowed.empty()) return;
  for (OperationInfo const &operation : operations()) {
    Spelling &spelling = spellings_[static_cast<std::size_t>(operation.op)];
    bool const is_call = operation.form == Form::call || operation.form == Form::local;
    bool const is_given = std::ranges::find(language.single.given, operation.op) != language.single.given.end();
    if (!is_call || is_given || spelling.precedence != 0 || operation.has(flag::BOOLEAN)) continue;
    spelling.pieces.insert(spelling.pieces.begin(), {std::string(language.single.narrowed)});
    spelling.precedence = binding::unary;
  }
}

std::string Spellings::words(Op op) const {
  std::string text;
  for (Piece const &piece : (*this)[op].pieces) text += piece.operand < 0 ? piece.text : " ";
  return text;
}

std::string Spellings::apply(Op op, std::string_view x, std::string_view y, std::string_view z) const {
  std::array const operands = {x, y, z};
  std::string text;
  for (Piece const &piece : (*this)[op].pieces)
    text += piece.operand < 0 ? std::string_view(piece.text) : operands[static_cast<std::size_t>(piece.operand)];
  return text;
}

} // namespace symreal
