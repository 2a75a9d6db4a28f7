// The functions of integer_functions.def, for the evaluation of operations.
#pragma once

#include <cmath>
#include <cstdint>

namespace symreal::integers {

using std::int32_t, std::int64_t, std::uint32_t, std::uint64_t, std::trunc; // as the text, which is C, spells them

#define INTEGER_FUNCTION(type, name, parameters, ...)                                                                  \
  inline type name parameters { __VA_ARGS__ }
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION

// A 64-bit integer as the value of a node, which is a double: its bits.
constexpr uint64_t bits(double value) noexcept { return __builtin_bit_cast(uint64_t, value); }
constexpr double held(uint64_t bits) noexcept { return __builtin_bit_cast(double, bits); }

// The low bits of an integer, converted to a type.
template <class T> double wrapped(double integer) noexcept {
  return static_cast<double>(static_cast<T>(wide_int(integer)));
}

} // namespace symreal::integers
