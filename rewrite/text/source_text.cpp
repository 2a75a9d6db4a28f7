#include "rewrite/text/source_text.h"

#include "engine/support/mutation/is_dropped.h"
#include "rewrite/request/request.h"

#include <clang/Basic/LangOptions.h>
#include <clang/Lex/Lexer.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string_view>

namespace symreal::rewrite {
namespace {

RawToken::Kind kind_of(clang::Token const &token) {
  if (token.is(clang::tok::raw_identifier)) return RawToken::Kind::word;
  if (token.is(clang::tok::comment)) return RawToken::Kind::comment;
  return token.isLiteral() ? RawToken::Kind::literal : RawToken::Kind::other;
}

// Calls `take` for each token from `begin` on, until it returns false.
void for_raw_tokens(std::string const &text, std::size_t begin, std::function<bool(RawToken const &)> const &take) {
  clang::LangOptions language;
  language.CPlusPlus = language.CPlusPlus11 = language.CPlusPlus14 = language.CPlusPlus17 = language.CPlusPlus20 = true;
  language.LineComment = true;
  clang::Lexer lexer(clang::SourceLocation(), language, text.data(), text.data() + begin, text.data() + text.size());
  lexer.SetCommentRetentionState(true);
  clang::Token token;
  while (!lexer.LexFromRawLexer(token) || token.isNot(clang::tok::eof)) {
    if (token.is(clang::tok::eof)) return;
    auto const end = static_cast<std::size_t>(lexer.getBufferLocation() - text.data());
    if (!take({kind_of(token), end - token.getLength(), end, token.isAtStartOfLine()})) return;
  }
}

// A number that is written as one, `nan` and `inf` among them.
std::optional<double> literal(std::string const &text) {
  char *end = nullptr;
  double const value = std::strtod(text.c_str(), &end);
  std::size_t const length = static_cast<std::size_t>(end - text.c_str());
  bool const is_literal = length > 0 && text.find_first_not_of(' ', length) == text.npos;
  return is_literal ? std::optional(value) : std::nullopt;
}

} // namespace

std::vector<RawToken> raw_tokens(std::string const &text) {
  std::vector<RawToken> tokens;
  for_raw_tokens(text, 0, [&](RawToken const &token) {
    tokens.push_back(token);
    return true;
  });
  return tokens;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t closing_parenthesis(std::string const &text, std::size_t open) {
  std::size_t closing = text.npos;
  int depth = 0;
  for_raw_tokens(text, open, [&](RawToken const &token) {
    if (token.kind != RawToken::Kind::other) return true;
    depth += (text[token.begin] == '(') - (text[token.begin] == ')');
    if (depth == 0) closing = token.begin;
    return depth != 0;
  });
  return closing;
}

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

bool is_not_finite(std::string const &number) {
  std::optional<double> const value = literal(number);
  return value && !std::isfinite(*value);
}

std::string wrong_range(std::string const &low, std::string const &high) {
  if (is_dropped("SYM204")) return "";
  for (std::string const *end : {&low, &high})
    if (is_not_finite(*end)) return "a range has two finite ends, and '" + *end + "' is not finite";
  std::optional<double> const first = literal(low), last = literal(high);
  return first && last && *first > *last ? "the range from " + low + " to " + high + " ends below where it begins" : "";
}

std::string normalised(std::string const &source) {
  std::string text;
  std::size_t end = 0;
  for (RawToken const &token : raw_tokens(source)) {
    if (token.kind == RawToken::Kind::comment) continue;
    if (token.begin != end && !text.empty()) text += ' ';
    text.append(source, token.begin, token.end - token.begin);
    end = token.end;
  }
  return text;
}

bool only_declaration_start(std::string const &source) {
  bool is_start = true, in_directive = false;
  for_raw_tokens(source, 0, [&](RawToken const &token) {
    if (token.kind == RawToken::Kind::comment) return true;
    char const c = source[token.begin];
    if (token.begins_line) in_directive = c == '#';
    is_start = in_directive || token.kind != RawToken::Kind::other || (c != ';' && c != '{' && c != '}');
    return is_start;
  });
  return is_start;
}

std::string with_real(std::string const &source) {
  std::string text;
  std::string_view previous;
  std::size_t end = 0;
  for (RawToken const &token : raw_tokens(source)) {
    if (token.kind != RawToken::Kind::word) continue;
    std::string_view const word = std::string_view(source).substr(token.begin, token.end - token.begin);
    text.append(source, end, token.begin - end);
    text += word == "double" && previous != "long" ? reserved_type_name : word;
    previous = word;
    end = token.end;
  }
  return text.append(source, end);
}

} // namespace symreal::rewrite
