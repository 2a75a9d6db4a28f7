#include "rewrite/text/raw_tokens.h"

#include <clang/Basic/LangOptions.h>
#include <clang/Lex/Lexer.h>

namespace symreal::rewrite {
namespace {

RawToken::Kind kind_of(clang::Token const &token) {
  if (token.is(clang::tok::raw_identifier)) return RawToken::Kind::word;
  if (token.is(clang::tok::comment)) return RawToken::Kind::comment;
  return token.isLiteral() ? RawToken::Kind::literal : RawToken::Kind::other;
}

} // namespace

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

std::vector<RawToken> raw_tokens(std::string const &text) {
  std::vector<RawToken> tokens;
  for_raw_tokens(text, 0, [&](RawToken const &token) {
    tokens.push_back(token);
    return true;
  });
  return tokens;
}

} // namespace symreal::rewrite
