// Number syntax of a language: literals and types, in double and single precision.
#pragma once

#include "engine/ops/operation.h"

#include <span>
#include <string_view>

namespace symreal {

// Literals that read back to the same bits.
struct NumberSyntax {
  std::string_view nan = {}, negative_nan = {}, infinity = {}, negative_infinity = {};
  std::string_view exponent = "e";       // between mantissa and exponent
  std::string_view suffix = {};          // of numbers without an exponent
  std::string_view negative_zero = {};   // if it differs from -0.0
  std::string_view exponent_suffix = {}; // of numbers with an exponent
  int sign_binding = 14;                 // binding strength of a signed number
};

// Type of a variable: a number, a truth value, or a 64-bit integer.
struct TypeSyntax {
  std::string_view name = {}, zero = {};
};

// Differences of single precision from double. An empty type: unsupported.
struct SingleSyntax {
  TypeSyntax number = {};
  NumberSyntax numbers = {};
  std::string_view call_suffix = {}; // of math library names: "f"
  std::string_view narrowed = {};    // before a call, if functions return doubles: "(float)"
  std::span<Op const> given = {};    // operations whose functions return their argument type
};

// A placeholder of this language's patterns, with its text in double and single precision.
struct Word {
  std::string_view name = {}, in_double = {}, in_single = {};
};

} // namespace symreal
