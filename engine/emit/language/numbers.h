// The numbers of a language: their spelling and their type, in double and in single precision.
#pragma once

#include "engine/ops/operation.h"

#include <span>
#include <string_view>

namespace symreal {

// Numbers are printed so that they read back to the same bits.
struct NumberSyntax {
  std::string_view nan = {}, negative_nan = {}, infinity = {}, negative_infinity = {};
  std::string_view exponent = "e";       // between mantissa and exponent
  std::string_view suffix = {};          // of numbers without an exponent
  std::string_view negative_zero = {};   // where it is not -0.0
  std::string_view exponent_suffix = {}; // of numbers with an exponent
  int sign_binding = 14;                 // how tightly a number with a sign binds
};

// A variable holds a number, a truth value, or an integer of 64 bits.
struct TypeSyntax {
  std::string_view name = {}, zero = {};
};

// How the language computes in single precision, where that is not as in double. No type: it cannot.
struct SingleSyntax {
  TypeSyntax number = {};
  NumberSyntax numbers = {};
  std::string_view call_suffix = {}; // of the names of the mathematical library: "f"
  std::string_view narrowed = {};    // before a call, where the functions give doubles: "(float)"
  std::span<Op const> given = {};    // those whose functions give what they take
};

// A place that patterns of this language have, with what stands there in double and in single precision.
struct Word {
  std::string_view name = {}, in_double = {}, in_single = {};
};

} // namespace symreal
