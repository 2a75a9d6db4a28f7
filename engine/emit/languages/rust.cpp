#include "engine/emit/languages/languages.h"
#include "engine/emit/rust/parts.h"

#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"Self",     "abstract", "as",       "async",   "await", "become", "bool",   "box",   "break",  "const",
     "continue", "crate",    "do",       "dyn",     "else",  "enum",   "extern", "f64",   "false",  "final",
     "fn",       "for",      "if",       "impl",    "in",    "let",    "loop",   "macro", "match",  "mod",
     "move",     "mut",      "override", "priv",    "pub",   "ref",    "return", "self",  "static", "std",
     "struct",   "super",    "trait",    "true",    "try",   "type",   "typeof", "u64",   "union",  "unsafe",
     "unsized",  "use",      "usize",    "virtual", "where", "while",  "yield"});

// Operations with processor instructions are methods; the others are called from C's library. Casts of numbers agree
// with C's within the range of the type.
static constexpr OperationSpelling spellings[] = {
    {Op::abs, "$real::abs($x)"},
    {Op::sqrt, "$real::sqrt($x)"},
    {Op::fma, "$real::mul_add($x, $y, $z)"},
    {Op::floor, "$real::floor($x)"},
    {Op::ceil, "$real::ceil($x)"},
    {Op::trunc, "$real::trunc($x)"},
    {Op::copysign, "$real::copysign($x, $y)"},
    {Op::f32, "f64::from($x:14 as f32)"},
    {Op::wrap_int8, "$real::from($x:14 as i64 as i8)"},
    {Op::wrap_int16, "$real::from($x:14 as i64 as i16)"},
    {Op::wrap_int32, "$real::from($x:14 as i64 as i32)"},
    {Op::wrap_uint8, "$real::from($x:14 as i64 as u8)"},
    {Op::wrap_uint16, "$real::from($x:14 as i64 as u16)"},
    {Op::wrap_uint32, "$real::from($x:14 as i64 as u32)"},
    {Op::wide_add, "u64::wrapping_add($x, $y)"},
    {Op::wide_sub, "u64::wrapping_sub($x, $y)"},
    {Op::wide_mul, "u64::wrapping_mul($x, $y)"},
    {Op::wide_select, "if $x { $y } else { $z }", 3},
    {Op::wide_value, "($x:14 as i64 as f64)"},
    {Op::wide_uvalue, "($x:14 as f64)"},
    {Op::wide_low, "f64::from($x:14 as u32)"},
    {Op::select, "if $x { $y } else { $z }", 3},
};

static constexpr BridgeInteger integers[] = {
    {"int", "c_int"},
    {"long", "c_long"},
    {"long long", "c_longlong"},
    {"short", "c_short"},
    {"signed char", "c_schar"},
    {"char", "c_char"},
    {"unsigned int", "c_uint"},
    {"unsigned long", "c_ulong"},
    {"unsigned long long", "c_ulonglong"},
    {"unsigned short", "c_ushort"},
    {"unsigned char", "c_uchar"},
    {"_Bool", "bool", "$value != 0.0", "f64::from(u8::from($value))"},
};

static constexpr BridgeSyntax bridge = {
    .integers = integers,
    .to_integer = "$value as std::os::raw::$type",
    .from_integer = "$value as f64",
    .number = {"$p: f64, ", "a[$at]"},
    .integer = {"$p: $type, ", "$value"},
    .input = {"$p: *const f64, ", "a[$at..$next].as_ptr()"},
    .output = {"$p: *mut f64, ", "r[$at..$next].as_mut_ptr()"},
    .object = {"$p: Numbers$count, ",
               "library::Numbers$count { m: std::convert::TryFrom::try_from(&a[$at..$next]).unwrap() }"},
    .copy = "    r[$at..$next].copy_from_slice(&a[$from..$from_next]);\n",
    .number_result = " -> f64",
    .integer_result = " -> $type",
    .object_result = " -> Numbers$count",
    .no_store = "    $made;\n",
    .number_store = "    r[0] = $made;\n",
    .object_store = "    let returned = $made;\n    r[..$count].copy_from_slice(&returned.m);\n",
    .made = "unsafe { library::c_$name($passed) }",
    .structure = "    #[repr(C)]\n    pub struct Numbers$count {\n        pub m: [f64; $count],\n    }\n\n",
    .begin = "/// Functions of the program's libraries, with structs as what they consist of.\n"
             "mod library {\n    use std::os::raw::*;\n\n",
    .declaration = "    extern \"C\" {\n        #[link_name = \"$c_name\"]\n"
                   "        pub fn c_$name($declared)$result;\n    }\n",
    .end = "}\n\n",
    .bridge = "fn $name(a: &[f64], r: &mut [f64]) {\n    let _ = (a.len(), r.len());\n$copies$stored}\n\n",
    .call = "$name(&[$arguments], &mut $array[$first..]);",
};

static constexpr Companion beside[] = {{"_main.rs", rust_mainline, "mainline"}};

Language language_rust() {
  Language rust;
  rust.names = {keywords, false};
  rust.comment = {"// ", "// ", ""};
  rust.lines = {.width = 100, .least = 60, .continuation = ""};
  rust.numbers = {"f64::NAN", "-f64::NAN", "f64::INFINITY", "f64::NEG_INFINITY"};
  rust.number = {"f64", "0.0"};
  rust.truth = {"bool", "false"};
  rust.wide = {"u64", "0"};
  rust.single = {.number = {"f32", "0.0"}, .numbers = {"f32::NAN", "-f32::NAN", "f32::INFINITY", "f32::NEG_INFINITY"}};
  rust.expressions = {
      .call_prefix = "libm::",
      .operations = spellings,
      .element = "$array[$index]",
      .yes = "true",
      .truth_as_number = "$real::from(u8::from($x))",
      .small_integer = "${value}_u64",
      .large_integer = "${value}_u64",
      .kept_integer = "$element.to_bits()",
      .hidden = "at_run($x)",
      .table_index = "table_index($index, $extent)",
  };
  rust.statements = {
      .variable = "let mut $name: $type = $value;",
      .constant = "let $name: $type = $value;",
      .set = "$name = $value;",
      .keep_integer = "$element = f64::from_bits($value);",
      .array = "let $name = &mut [0.0_$real; $count];",
      .zero_array = "let $name = &mut [0.0_$real; $count];",
      .open = "if $condition {",
      .otherwise = "} else {",
      .close = "}",
      .check = "if $condition { return $number; }",
  };
  rust.functions = {
      .head = "pub fn $name($parameters)$result {",
      .local_head = "${apart}fn $name($parameters)$result {",
      .end = "}",
      .apart = "#[inline(never)] ",
      .no_result = "",
      .status = " -> i32",
      .input = "$name: &[$real]",
      .output = "$name: &mut [$real]",
      .unused = "let _ = $name;",
      .success = "0",
      .call = "$name($arguments);",
      .checked_call = "let failed = $name($arguments);\nif failed != 0 { return failed; }",
      .parts_store = true,
  };
  rust.tables = {
      .begin = "static $name: [$real; $count] = [",
      .end = "];",
      .index_helper = "// An index outside of its table reads the nearest element.\n"
                      "fn table_index(index: $real, extent: usize) -> usize {\n"
                      "    if !(index > 0.0) { return 0; }\n"
                      "    if index < extent as $real { index as usize } else { extent - 1 }\n"
                      "}\n\n",
  };
  rust.externals = {.bridge = bridge};
  rust.files = {
      .extension = ".rs",
      .fast_when = " Any compiler flags.",
      .begin = rust_begin,
      .integer_functions = rust_integer_functions,
      .hide_helper =
          "// An argument that is constant on some path: a compiler would evaluate the call there, and round\n"
          "// otherwise than the library.\n"
          "fn at_run(x: $real) -> $real {\n"
          "    unsafe { std::ptr::read_volatile(&x) }\n"
          "}\n\n",
      .end = rust_end,
      .companions = beside,
  };
  return rust;
}

} // namespace symreal
