#include "engine/emit/rust/parts.h"

#include <array>
#include <fmt/format.h>
#include <set>
#include <string_view>

namespace symreal {

namespace {

// The functions of integer_functions.def in Rust, in the same order.
struct Function {
  std::string_view name, head, body;
  bool calls_wide_int = false;
};
constexpr std::array functions = {
    Function{"to_int32", "(x: $real) -> $real",
             "if x > -2147483649.0 && x < 2147483648.0 { x as i32 as $real } else { -2147483648.0 }"},
    Function{"to_int64", "(x: $real) -> $real",
             "if x >= -9223372036854775808.0 && x < 9223372036854775808.0 { x as i64 as $real } else { "
             "-9223372036854775808.0 }"},
    Function{"wide_int", "(x: $real) -> u64",
             "if x >= -9223372036854775808.0 && x < 9223372036854775808.0 { x as i64 as u64 } else { 1 << 63 }"},
    Function{"wide_uint", "(x: $real) -> u64",
             "if x >= 9223372036854775808.0 { wide_int(x - 9223372036854775808.0) ^ (1 << 63) } else { wide_int(x) }",
             true},
    Function{"wide", "(high: $real, low: $real) -> u64", "(wide_int(high) << 32) | (wide_int(low) & 0xFFFF_FFFF)",
             true},
    Function{"int_div", "(x: $real, y: $real) -> $real", "(x / y).trunc() + 0.0"},
    Function{"int_neg", "(x: $real) -> $real", "if x == 0.0 { 0.0 } else { -x }"},
    Function{"mul_uint32", "(x: $real, y: $real) -> $real",
             "f64::from((wide_int(x) as u32).wrapping_mul(wide_int(y) as u32))", true},
    Function{"wide_div", "(x: u64, y: u64) -> u64",
             "if y == 0 { 0 } else { (x as i64).wrapping_div(y as i64) as u64 }"},
    Function{"wide_rem", "(x: u64, y: u64) -> u64",
             "if y == 0 { 0 } else { (x as i64).wrapping_rem(y as i64) as u64 }"},
    Function{"wide_udiv", "(x: u64, y: u64) -> u64", "if y == 0 { 0 } else { x / y }"},
    Function{"wide_urem", "(x: u64, y: u64) -> u64", "if y == 0 { 0 } else { x % y }"},
    Function{"wide_and", "(x: u64, y: u64) -> u64", "x & y"},
    Function{"wide_or", "(x: u64, y: u64) -> u64", "x | y"},
    Function{"wide_xor", "(x: u64, y: u64) -> u64", "x ^ y"},
    Function{"wide_shl", "(x: u64, n: u64) -> u64", "x << (n & 63)"},
    Function{"wide_shr", "(x: u64, n: u64) -> u64", "((x as i64) >> (n & 63)) as u64"},
    Function{"wide_ushr", "(x: u64, n: u64) -> u64", "x >> (n & 63)"},
    Function{"wide_less", "(x: u64, y: u64) -> bool", "(x as i64) < (y as i64)"},
};

constexpr std::array names = {
#define INTEGER_FUNCTION(type, name, parameters, ...) std::string_view(#name),
#include <symreal/integer_functions.def>
#undef INTEGER_FUNCTION
};
constexpr bool are_complete() {
  if (names.size() != functions.size()) return false;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] != functions[k].name) return false;
  return true;
}
static_assert(are_complete());

} // namespace

std::string rust_integer_functions(Emission const &emission) {
  std::set<std::string_view> wanted = emission.uses.integer_functions;
  for (Function const &function : functions)
    if (function.calls_wide_int && wanted.contains(function.name)) wanted.insert("wide_int");
  std::string text;
  for (Function const &function : functions)
    if (wanted.contains(function.name))
      text += with_words(emission.language, fmt::format("#[inline]\nfn {}{} {{\n    {}\n}}\n", function.name,
                                                        function.head, function.body));
  return text.empty() ? text : "// Integers, as gcc has them on x86-64.\n" + text + "\n";
}

} // namespace symreal
