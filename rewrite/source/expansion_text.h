// The text that chosen macro invocations expand to, put together from the tokens on their way to the parser.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <string>

namespace symreal::rewrite {

class ExpansionText {
public:
  explicit ExpansionText(SourceMap const &map) : map_(map) {}

  // The outermost invocation around the location is wanted.
  void want(clang::SourceLocation location);
  // Every token that reaches the parser.
  void token(clang::Token const &token);
  // Each becomes a use.
  void collect(Facts &facts) const;

private:
  struct Text {
    clang::CharSourceRange invocation;
    std::string tokens;
  };
  SourceMap const &map_;
  std::map<clang::SourceLocation, Text> texts_; // by where the invocation begins
};

} // namespace symreal::rewrite
