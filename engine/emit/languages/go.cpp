#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"append", "bool",   "break",       "case",  "chan",    "const",     "continue", "default", "defer",
     "else",   "error",  "fallthrough", "false", "float32", "float64",   "for",      "func",    "go",
     "goto",   "if",     "import",      "int",   "int64",   "interface", "iota",     "len",     "main",
     "make",   "map",    "math",        "nil",   "package", "panic",     "range",    "return",  "select",
     "string", "struct", "switch",      "true",  "type",    "uint32",    "uint64",   "unsafe",  "var"});
static_assert(std::ranges::is_sorted(keywords));

// An explicit conversion rounds a product: otherwise Go may fuse it with a sum.
static constexpr OperationSpelling spellings[] = {
    {Op::mul, "float64($x:13 * $y:14)"},
    {Op::abs, "math.Abs($x)"},
    {Op::sqrt, "math.Sqrt($x)"},
    {Op::cbrt, "math.Cbrt($x)"},
    {Op::hypot, "math.Hypot($x, $y)"},
    {Op::fma, "math.FMA($x, $y, $z)"},
    {Op::fmin, "fmin($x, $y)"},
    {Op::fmax, "fmax($x, $y)"},
    {Op::fdim, "fdim($x, $y)"},
    {Op::fmod, "math.Mod($x, $y)"},
    {Op::remainder, "math.Remainder($x, $y)"},
    {Op::floor, "math.Floor($x)"},
    {Op::ceil, "math.Ceil($x)"},
    {Op::trunc, "math.Trunc($x)"},
    {Op::round, "math.Round($x)"},
    {Op::rint, "math.RoundToEven($x)"},
    {Op::copysign, "math.Copysign($x, $y)"},
    {Op::nextafter, "nextafter($x, $y)"},
    {Op::logb, "math.Logb($x)"},
    {Op::f32, "float64(float32($x))"},
    {Op::wrap_int8, "float64(int8(signed(wide_int($x))))"},
    {Op::wrap_int16, "float64(int16(signed(wide_int($x))))"},
    {Op::wrap_int32, "float64(int32(signed(wide_int($x))))"},
    {Op::wrap_uint8, "float64(uint8(wide_int($x)))"},
    {Op::wrap_uint16, "float64(uint16(wide_int($x)))"},
    {Op::wrap_uint32, "float64(uint32(wide_int($x)))"},
    {Op::wide_select, "pick_integer($x, $y, $z)"},
    {Op::wide_value, "float64(signed($x))"},
    {Op::wide_uvalue, "float64($x)"},
    {Op::wide_low, "float64(uint32($x))"},
    {Op::sin, "math.Sin($x)"},
    {Op::cos, "math.Cos($x)"},
    {Op::tan, "math.Tan($x)"},
    {Op::asin, "asin($x)"},
    {Op::acos, "acos($x)"},
    {Op::atan, "math.Atan($x)"},
    {Op::atan2, "math.Atan2($x, $y)"},
    {Op::sinh, "math.Sinh($x)"},
    {Op::cosh, "math.Cosh($x)"},
    {Op::tanh, "math.Tanh($x)"},
    {Op::asinh, "math.Asinh($x)"},
    {Op::acosh, "math.Acosh($x)"},
    {Op::atanh, "math.Atanh($x)"},
    {Op::exp, "math.Exp($x)"},
    {Op::exp2, "math.Exp2($x)"},
    {Op::expm1, "math.Expm1($x)"},
    {Op::log, "log($x)"},
    {Op::log2, "log2($x)"},
    {Op::log10, "log10($x)"},
    {Op::log1p, "math.Log1p($x)"},
    {Op::pow, "pow($x, $y)"},
    {Op::erf, "math.Erf($x)"},
    {Op::erfc, "math.Erfc($x)"},
    {Op::tgamma, "math.Gamma($x)"},
    {Op::lgamma, "lgamma($x)"},
    {Op::select, "pick($x, $y, $z)"},
};

static constexpr Helper helpers[] = {
    {"nextafter", R"(// Of zeros the second, as in C.
func nextafter(x, y float64) float64 {
    if x == y {
        return y
    }
    return math.Nextafter(x, y)
}
)"},
    {"table_index", R"(// An index outside of its table reads the nearest element.
func table_index(index float64, extent int) int {
    if !(index > 0) {
        return 0
    }
    if index < float64(extent) {
        return int(index)
    }
    return extent - 1
}
)"},
    {"number", R"(func number(c bool) float64 {
    if c {
        return 1
    }
    return 0
}
)"},
    {"pick", R"(func pick(c bool, y, z float64) float64 {
    if c {
        return y
    }
    return z
}
)"},
    {"pick_integer", R"(func pick_integer(c bool, y, z uint64) uint64 {
    if c {
        return y
    }
    return z
}
)"},
    {"signed", R"(func signed(x uint64) int64 {
    return int64(x)
}
)"},
    {"fmin", R"(func fmin(x, y float64) float64 {
    if x != x || y < x {
        return y
    }
    return x
}
)"},
    {"fmax", R"(func fmax(x, y float64) float64 {
    if x != x || y > x {
        return y
    }
    return x
}
)"},
    {"fdim", R"(func fdim(x, y float64) float64 {
    if x <= y {
        return 0
    }
    return x - y
}
)"},
    {"log", R"(// The logarithm of Go's package is wrong below the normal numbers.
func log(x float64) float64 {
    if x > 0 && x < 0x1p-1022 {
        return math.Log(x*0x1p54) - 37.42994775023705
    }
    return math.Log(x)
}
)"},
    {"log2", R"(// Near 1 the logarithm of Go's package subtracts numbers of nearly equal size.
func log2(x float64) float64 {
    if x > 0.75 && x < 1.5 {
        return math.Log(x) * math.Log2E
    }
    return math.Log2(x)
}
)"},
    {"asin", R"(// Near 1 and -1 the function of Go's package subtracts numbers of nearly equal size.
func asin(x float64) float64 {
    if math.Abs(x) > 0.5 {
        return math.Copysign(math.Pi/2-2*math.Asin(math.Sqrt((1-math.Abs(x))/2)), x)
    }
    return math.Asin(x)
}
)"},
    {"acos", R"(// Near 1 the function of Go's package subtracts numbers of nearly equal size.
func acos(x float64) float64 {
    if x > 0.5 {
        return 2 * math.Asin(math.Sqrt((1-x)/2))
    }
    return math.Acos(x)
}
)"},
    {"pow", R"(// The power of Go's package is wrong where the base is below the normal numbers.
func pow(x, y float64) float64 {
    if x != 0 && math.Abs(x) < 0x1p-1022 && !math.IsInf(y, 0) {
        return math.Pow(x*0x1p54, y) * math.Exp2(-54*y)
    }
    return math.Pow(x, y)
}
)"},
    {"log10", R"(func log10(x float64) float64 {
    if x > 0 && x < 0x1p-1022 {
        return math.Log10(x*0x1p54) - 16.255619765854984
    }
    return math.Log10(x)
}
)"},
    {"lgamma", R"(func lgamma(x float64) float64 {
    if math.Abs(x) < 1e-200 {
        return -log(math.Abs(x))
    }
    value, _ := math.Lgamma(x)
    if math.IsInf(x, -1) {
        return -x
    }
    return value
}
)"},
    {"to_int32", R"(func to_int32(x float64) float64 {
    if x > -2147483649 && x < 2147483648 {
        return float64(int32(x))
    }
    return -2147483648
}
)"},
    {"to_int64", R"(func to_int64(x float64) float64 {
    return float64(signed(wide_int(x)))
}
)"},
    {"wide_int", R"(func wide_int(x float64) uint64 {
    if x >= -0x1p63 && x < 0x1p63 {
        return uint64(int64(x))
    }
    return 1 << 63
}
)"},
    {"wide_uint", R"(func wide_uint(x float64) uint64 {
    if x >= 0x1p63 {
        return wide_int(x-0x1p63) ^ (1 << 63)
    }
    return wide_int(x)
}
)"},
    {"wide", R"(func wide(high, low float64) uint64 {
    return wide_int(high)<<32 | wide_int(low)&0xFFFFFFFF
}
)"},
    {"int_div", R"(func int_div(x, y float64) float64 {
    return math.Trunc(x/y) + 0
}
)"},
    {"int_neg", R"(func int_neg(x float64) float64 {
    if x == 0 {
        return 0
    }
    return -x
}
)"},
    {"mul_uint32", R"(func mul_uint32(x, y float64) float64 {
    return float64(uint32(wide_int(x)) * uint32(wide_int(y)))
}
)"},
    {"wide_div", R"(func wide_div(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return uint64(int64(x) / int64(y))
}
)"},
    {"wide_rem", R"(func wide_rem(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return uint64(int64(x) % int64(y))
}
)"},
    {"wide_udiv", R"(func wide_udiv(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return x / y
}
)"},
    {"wide_urem", R"(func wide_urem(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return x % y
}
)"},
    {"wide_and", "func wide_and(x, y uint64) uint64 {\n    return x & y\n}\n"},
    {"wide_or", "func wide_or(x, y uint64) uint64 {\n    return x | y\n}\n"},
    {"wide_xor", "func wide_xor(x, y uint64) uint64 {\n    return x ^ y\n}\n"},
    {"wide_shl", "func wide_shl(x, n uint64) uint64 {\n    return x << (n & 63)\n}\n"},
    {"wide_shr", "func wide_shr(x, n uint64) uint64 {\n    return uint64(int64(x) >> (n & 63))\n}\n"},
    {"wide_ushr", "func wide_ushr(x, n uint64) uint64 {\n    return x >> (n & 63)\n}\n"},
    {"wide_less", "func wide_less(x, y uint64) bool {\n    return int64(x) < int64(y)\n}\n"},
};

static constexpr Companion beside[] = {{"_main.go", module_main, "mainline"}};

Language language_go() {
  Language go;
  go.names = {keywords, false};
  go.comment = {"// ", "// ", ""};
  go.lines = {.width = 1000000, .step = 4}; // a line must not end before an operator
  go.numbers = {"math.NaN()", "math.NaN()", "math.Inf(1)", "math.Inf(-1)", "e", "", "math.Copysign(0, -1)"};
  go.number = {"float64", "0.0"};
  go.truth = {"bool", "false"};
  go.wide = {"uint64", "uint64(0)"};
  go.expressions = {
      .operations = spellings,
      .element = "$array[$index]",
      .yes = "true",
      .truth_as_number = "number($x)",
      .small_integer = "uint64($value)",
      .large_integer = "uint64($value)",
      .kept_integer = "math.Float64bits($element)",
      .table_index = "table_index($index, $extent)",
  };
  go.statements = {
      .variable = "$name := $value",
      .constant = "$name := $value",
      .set = "$name = $value",
      .keep_integer = "$element = math.Float64frombits($value)",
      .array = "$name := make([]float64, $count)",
      .zero_array = "$name := make([]float64, $count)",
      .open = "if $condition {",
      .otherwise = "} else {",
      .close = "}",
      .check = "if $condition { return $number }",
  };
  go.functions = {
      .head = "func $Name($parameters)$result {",
      .local_head = "func $name($parameters)$result {",
      .end = "}",
      .no_result = "",
      .status = " int",
      .input = "$name []float64",
      .output = "$name []float64",
      .success = "return 0",
      .call = "$name($arguments)",
      .checked_call = "if failed := $name($arguments); failed != 0 { return failed }",
      .parts_store = true,
  };
  go.tables = {.begin = "var $name = [...]float64{", .end = "}"};
  go.files = {
      .extension = ".go",
      .kept_when = ", but for the functions of\npackage math, which are Go's own",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  go.module = {
      .begin = "\npackage $package\n\nimport (\n    \"math\"\n    \"unsafe\"\n)\n\nvar _ = math.Pi\n\n",
      .size = "const $Name = $value\n",
      .index_list = "var $Name = [$count]int{$values}\n",
      .structure = {.begin = "\n// The numbers of the $role by their names.\ntype $Role struct {\n",
                    .end = "}\n\n// Numbers gives the array that this is.\nfunc (x *$Role) Numbers() []float64 {\n"
                           "    return unsafe.Slice((*float64)(unsafe.Pointer(x)), $count)\n}\n",
                    .object = "    $Name $type\n",
                    .number = "float64",
                    .array = "[$extent]$element"},
      .functions = "\nvar _ unsafe.Pointer\n\n",
      .guards_begin = "\n// $GuardText gives the condition of a guard and its places in the source.\n"
                      "func $GuardText(guard int) string {\n    text := [...]string{\n",
      .guard = "        $text,\n",
      .guards_end = "    }\n    if guard > 0 && guard <= len(text) {\n        return text[guard-1]\n    }\n"
                    "    return \"\"\n}\n",
      .main = R"(
package main

import (
    "fmt"
    "math"
    "os"
    "strconv"
    "strings"
)

// Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
func main() {
    var _ = math.Pi
    input := []float64{$input_values}
    parameters := []float64{$parameter_values}
    names := []string{$labels}
    constants := make([]float64, $constants)
    output := make([]float64, $outputs)
    for i, argument := range os.Args[1:] {
        value, _ := strconv.ParseFloat(argument, 64)
        if i < len(input) {
            input[i] = value
        } else if i < len(input)+len(parameters) {
            parameters[i-len(input)] = value
        }
    }
    $Preprocess(parameters, constants)
    $call
    for i, name := range names {
        fmt.Println(name + " = " + strings.ReplaceAll(strconv.FormatFloat(output[i], 'g', -1, 64), "+Inf", "Inf"))
    }
}
)",
      .call = "$Compute(input, constants, output)",
      .checked_call = R"(if guard := $Compute(input, constants, output); guard != 0 {
        fmt.Fprintf(os.Stderr, "guard %d does not hold: %s\n", guard, $GuardText(guard))
        os.Exit(1)
    })",
  };
  return go;
}

} // namespace symreal
