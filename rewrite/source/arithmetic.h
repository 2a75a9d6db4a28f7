// Source text that changes the arithmetic of functions: optimize("fast-math") in an attribute, #pragma STDC FP_CONTRACT
// ON. It is removed from the reference build as well, like flags of this kind.
#pragma once

#include "rewrite/facts/facts.h"
#include "rewrite/source/clang.h"
#include "rewrite/source/source_map.h"

#include <memory>

namespace symreal::rewrite {

std::unique_ptr<clang::PPCallbacks> make_arithmetic_pragma_watch(SourceMap const &map, Facts &facts);

// Reports `#pragma STDC FENV_ROUND FE_UPWARD`: arithmetic that does not round to nearest, by the text.
std::unique_ptr<clang::PPCallbacks> make_rounding_pragma_watch(SourceMap const &map, Facts &facts);

// Reader of attributes from the tokens, in their order: Clang's parser drops those that only gcc knows.
class ArithmeticAttributes {
public:
  ArithmeticAttributes(SourceMap const &map, Facts &facts) : map_(map), facts_(facts) {}
  void token(clang::Token const &token);

private:
  void within(clang::Token const &token);
  void option(clang::Token const &token);

  SourceMap const &map_;
  Facts &facts_;
  clang::tok::TokenKind before_ = clang::tok::unknown;
  bool is_announced_ = false; // by the word __attribute__
  unsigned depth_ = 0;        // of brackets, within an attribute
  unsigned options_depth_ = 0;
  bool is_target_ = false;
};

} // namespace symreal::rewrite
