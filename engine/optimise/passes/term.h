// Small expressions written as S-expressions: "(mul x (neg y))". The language of rewrite rules and of derivatives.
#pragma once

#include "engine/ops/operation.h"

#include <functional>
#include <string_view>
#include <vector>

namespace symreal {

struct Term {
  enum class Kind { variable, number, operation } kind;
  char variable = 0; // a lower-case letter; in rules k stands for a constant, other letters for any node
  double number = 0;
  Op op = Op::constant;
  std::vector<Term> operands = {};
};

// The text is part of a table of ours, so an error is an internal failure.
Term parse_term(std::string_view text);

double evaluate(Term const &term, std::function<double(char)> const &variable);

} // namespace symreal
