// The text that chosen macro invocations expand to, put together from the tokens on their way to the parser.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace symreal::rewrite {

class ExpansionText {
public:
  explicit ExpansionText(SourceMap const &map) : map_(map) {}

  // Requests the expansion of the outermost invocation around the location, or in an argument of one: for its tokens,
  // or for its string literals.
  enum class For : unsigned char { words, strings };
  void want(clang::SourceLocation location, For what);
  // Receives every token that reaches the parser.
  void token(clang::Token const &token);
  // Turns each request into a use. An expansion wanted for strings that makes other tokens stays: its names may be
  // rewritten, and a type's name in a string is hardly ever more than printed.
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

// Collection of macro arguments that become text (#parameter) or part of a pasted token (parameter ## ...).
//
// An argument in which another macro was expanded first takes its text from that macro's body, which has other uses,
// and may become REAL. The expansion of the outermost macro is noted instead.
std::unique_ptr<clang::PPCallbacks> make_quoted_argument_collector(SourceMap const &map, Facts &facts,
                                                                   ExpansionText &expansions);

} // namespace symreal::rewrite
