// The text that chosen macro invocations expand to, put together from the tokens on their way to the parser.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <string>
#include <vector>

namespace symreal::rewrite {

class ExpansionText {
public:
  explicit ExpansionText(SourceMap const &map) : map_(map) {}

  // The outermost invocation around the location is wanted, or that in an argument of one; for the words that it makes,
  // or for the strings.
  enum class For : unsigned char { words, strings };
  void want(clang::SourceLocation location, For what);
  // Every token that reaches the parser.
  void token(clang::Token const &token);
  // Each becomes a use. One that makes more than strings is left as it is if it is wanted for them: names in it may be
  // rewritten, and what a string says of a type is hardly ever more than printed.
  void collect(Facts &facts);

private:
  void finish();
  void add(clang::Token const &token, clang::SourceLocation invocation, clang::SourceLocation use);

  struct Text {
    clang::CharSourceRange invocation;
    bool makes_words = false;
    bool has_names = false;
    clang::SourceLocation use = {}; // in the body of the macro that it is an argument of
    std::string tokens = {};
  };
  SourceMap const &map_;
  // The invocation whose tokens pass: whether it is wanted shows behind the first of them, where a macro within it
  // does.
  clang::SourceLocation invocation_;
  std::vector<clang::Token> tokens_;
  std::map<clang::SourceLocation, Text> texts_; // by where the invocation begins
};

} // namespace symreal::rewrite
