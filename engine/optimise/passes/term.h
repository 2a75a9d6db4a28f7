// Terms: small S-expressions such as "(mul x (neg y))", the language of rewrite rules and derivatives.
#pragma once

#include "engine/ops/operation.h"

#include <functional>
#include <string_view>
#include <vector>

namespace symreal {

struct Term {
  enum class Kind { variable, number, operation } kind;
  char variable = 0; // a lower-case letter; in rules k stands for a constant, p for a parametric node, others for any
  double number = 0;
  Op op = Op::constant;
  std::vector<Term> operands = {};
};

// Parses text of a built-in table, so an error is an internal failure.
Term parse_term(std::string_view text);

double evaluate(Term const &term, std::function<double(char)> const &variable);

} // namespace symreal
