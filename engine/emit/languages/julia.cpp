#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"Bool",   "Float32", "Float64",    "Inf",    "Int",    "Int64", "NaN",     "UInt32",   "UInt64",
     "Vector", "abs",     "baremodule", "begin",  "break",  "catch", "const",   "continue", "copysign",
     "do",     "else",    "elseif",     "end",    "export", "false", "finally", "for",      "function",
     "global", "if",      "import",     "in",     "isa",    "let",   "libm",    "local",    "macro",
     "module", "quote",   "return",     "struct", "true",   "try",   "using",   "where",    "while"});
static_assert(std::ranges::is_sorted(keywords));

// Functions of C's library are called by name; these operations are Julia's own.
static constexpr OperationSpelling spellings[] = {
    {Op::abs, "abs($x)"},
    {Op::floor, "floor($x)"},
    {Op::ceil, "ceil($x)"},
    {Op::trunc, "trunc($x)"},
    {Op::rint, "round($x)"},
    {Op::round, "round($x, RoundNearestTiesAway)"},
    {Op::copysign, "copysign($x, $y)"},
    {Op::f32, "Float64(Float32($x))"},
    {Op::wrap_int8, "Float64(wide_int($x) % Int8)"},
    {Op::wrap_int16, "Float64(wide_int($x) % Int16)"},
    {Op::wrap_int32, "Float64(wide_int($x) % Int32)"},
    {Op::wrap_uint8, "Float64(wide_int($x) % UInt8)"},
    {Op::wrap_uint16, "Float64(wide_int($x) % UInt16)"},
    {Op::wrap_uint32, "Float64(wide_int($x) % UInt32)"},
    {Op::wide_value, "Float64(signed($x))"},
    {Op::wide_uvalue, "Float64($x)"},
    {Op::wide_low, "Float64($x:14 % UInt32)"},
};

#define OF_ONE(name) {"c_" #name, "c_" #name "(x) = ccall((:" #name ", libm), Float64, (Float64,), x)\n", true}
#define OF_TWO(name)                                                                                                   \
  {"c_" #name, "c_" #name "(x, y) = ccall((:" #name ", libm), Float64, (Float64, Float64), x, y)\n", true}

static constexpr Helper helpers[] = {
    OF_ONE(sqrt),
    OF_ONE(cbrt),
    OF_TWO(hypot),
    {"c_fma", "c_fma(x, y, z) = ccall((:fma, libm), Float64, (Float64, Float64, Float64), x, y, z)\n", true},
    OF_TWO(fmin),
    OF_TWO(fmax),
    OF_TWO(fdim),
    OF_TWO(fmod),
    OF_TWO(remainder),
    OF_TWO(nextafter),
    OF_ONE(logb),
    OF_ONE(sin),
    OF_ONE(cos),
    OF_ONE(tan),
    OF_ONE(asin),
    OF_ONE(acos),
    OF_ONE(atan),
    OF_TWO(atan2),
    OF_ONE(sinh),
    OF_ONE(cosh),
    OF_ONE(tanh),
    OF_ONE(asinh),
    OF_ONE(acosh),
    OF_ONE(atanh),
    OF_ONE(exp),
    OF_ONE(exp2),
    OF_ONE(expm1),
    OF_ONE(log),
    OF_ONE(log2),
    OF_ONE(log10),
    OF_ONE(log1p),
    OF_TWO(pow),
    OF_ONE(erf),
    OF_ONE(erfc),
    OF_ONE(tgamma),
    OF_ONE(lgamma),
    {"table_index", R"(# An index outside of its table reads the nearest element.
table_index(index, extent) = !(index > 0) ? 0 : index < extent ? unsafe_trunc(Int, index) : extent - 1
)"},
    {"wide_int", R"(wide_int(x) = -9.223372036854775808e18 <= x < 9.223372036854775808e18 ?
    unsigned(unsafe_trunc(Int64, x)) : 0x8000000000000000
)"},
    {"wide_uint", R"(wide_uint(x) = x >= 9.223372036854775808e18 ?
    wide_int(x - 9.223372036854775808e18) ⊻ 0x8000000000000000 : wide_int(x)
)"},
    {"wide", "wide(high, low) = wide_int(high) << 32 | wide_int(low) & 0x00000000ffffffff\n"},
    {"to_int32", "to_int32(x) = -2147483649.0 < x < 2147483648.0 ? trunc(x) + 0.0 : -2147483648.0\n"},
    {"to_int64", "to_int64(x) = Float64(signed(wide_int(x)))\n"},
    {"int_div", "int_div(x, y) = trunc(x/y) + 0.0\n"},
    {"int_neg", "int_neg(x) = x == 0 ? 0.0 : -x\n"},
    {"mul_uint32", "mul_uint32(x, y) = Float64((wide_int(x)*wide_int(y)) % UInt32)\n"},
    {"wide_div", R"(function wide_div(x, y)
    y == 0 && return UInt64(0)
    return signed(y) == -1 ? -x : unsigned(div(signed(x), signed(y)))
end
)"},
    {"wide_rem", "wide_rem(x, y) = y == 0 || signed(y) == -1 ? UInt64(0) : unsigned(rem(signed(x), signed(y)))\n"},
    {"wide_udiv", "wide_udiv(x, y) = y == 0 ? UInt64(0) : div(x, y)\n"},
    {"wide_urem", "wide_urem(x, y) = y == 0 ? UInt64(0) : rem(x, y)\n"},
    {"wide_and", "wide_and(x, y) = x & y\n"},
    {"wide_or", "wide_or(x, y) = x | y\n"},
    {"wide_xor", "wide_xor(x, y) = x ⊻ y\n"},
    {"wide_shl", "wide_shl(x, n) = x << (n & 63)\n"},
    {"wide_shr", "wide_shr(x, n) = unsigned(signed(x) >> (n & 63))\n"},
    {"wide_ushr", "wide_ushr(x, n) = x >> (n & 63)\n"},
    {"wide_less", "wide_less(x, y) = signed(x) < signed(y)\n"},
};

static constexpr BridgeInteger integers[] = {
    {"int", "Cint"},
    {"long", "Clong"},
    {"long long", "Clonglong"},
    {"short", "Cshort"},
    {"signed char", "Int8"},
    {"char", "Cchar"},
    {"unsigned int", "Cuint"},
    {"unsigned long", "Culong"},
    {"unsigned long long", "Culonglong"},
    {"unsigned short", "Cushort"},
    {"unsigned char", "Cuchar"},
    {"_Bool", "Bool"},
};

static constexpr BridgeSyntax bridge = {
    .integers = integers,
    .to_integer = "$type($value)",
    .from_integer = "Float64($value)",
    .number = {"Cdouble, ", "a[$at]"},
    .integer = {"$type, ", "$value"},
    .input = {"Ptr{Cdouble}, ", "pointer(a, $at)"},
    .output = {"Ptr{Cdouble}, ", "pointer(r, $at)"},
    .object = {"Numbers$count, ", "Numbers$count(Tuple(a[$at:$last]))"},
    .copy = "    r[$at:$last] = a[$from:$from_last]\n",
    .no_result = "Cvoid",
    .number_result = "Cdouble",
    .integer_result = "$type",
    .object_result = "Numbers$count",
    .no_store = "    GC.@preserve a r $made\n",
    .number_store = "    r[1] = GC.@preserve a r $made\n",
    .object_store = "    r[1:$count] .= (GC.@preserve a r $made).m\n",
    .made = "ccall(library_function(:$c_name), $result, ($declared), $passed)",
    .structure = "struct Numbers$count\n    m::NTuple{$count, Cdouble}\nend\n",
    .begin =
        R"(# Functions of the program's libraries, with structs as what they consist of, in the library that use_library names.
const library = Ref{Ptr{Cvoid}}(C_NULL)
use_library(path) = library[] = Base.Libc.Libdl.dlopen(path)
library_function(name) = library[] != C_NULL ? Base.Libc.Libdl.dlsym(library[], name) :
    error("the library that has $$name is not known: call use_library")

)",
    .bridge = "function $name(a, r)\n$copies$stored    return\nend\n",
    .call = "$name(Float64[$arguments], view($array, $first:length($array)))",
};

static constexpr Companion beside[] = {{"_main.jl", module_main, "mainline"}};

Language language_julia() {
  Language julia;
  julia.names = {.keywords = keywords};
  julia.has_namespace = true;
  julia.comment = {"# ", "# ", ""};
  julia.lines = {.width = 1000000, .step = 4}; // a line ends wherever an expression could
  julia.numbers = {"NaN", "NaN", "Inf", "-Inf"};
  julia.number = {"", "0.0"};
  julia.truth = {"", "false"};
  julia.wide = {"", "UInt64(0)"};
  julia.expressions = {
      .call_prefix = "c_",
      .operations = spellings,
      .element = "$array[$index]",
      .first_index = 1,
      .yes = "true",
      .truth_as_number = "Float64($x)",
      .small_integer = "UInt64($value)",
      .large_integer = "UInt64(0x$hex)",
      .kept_integer = "reinterpret(UInt64, $element)",
      .table_index = "table_index($index, $extent)",
  };
  julia.statements = {
      .variable = "$name = $value",
      .constant = "$name = $value",
      .set = "$name = $value",
      .keep_integer = "$element = reinterpret(Float64, $value)",
      .array = "$name = zeros($count)",
      .zero_array = "$name = zeros($count)",
      .open = "if $condition",
      .otherwise = "else",
      .close = "end",
      .check = "if $condition; return $number; end",
  };
  julia.functions = {
      .head = "function $name!($parameters)",
      .local_head = "function $name!($parameters)",
      .end = "end",
      .input = "$name",
      .output = "$name",
      .output_first = true,
      .success = "return 0",
      .finish = "",
      .call = "$name!($arguments)",
      .checked_call = "failed = $name!($arguments)\nif failed != 0; return failed; end",
      .parts_store = true,
  };
  julia.tables = {.begin = "const $name = [", .end = "]"};
  julia.externals = {.bridge = bridge};
  julia.files = {
      .extension = ".jl",
      .kept_when = ", where the library\nof C is the same and @fastmath is not used",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  julia.strings = {.quote = "\"", .escaped = "\"\\$"};
  julia.module = {
      .begin = R"(
module $Module

# Where the mathematical library of C is.
const libm = Sys.iswindows() ? "ucrtbase" : Sys.isapple() ? "libSystem" : "libm.so.6"

)",
      .size = "const $name = $value\n",
      .index_list = "const $name = Int[$values]\n",
      .places = {.begin = "\n# The index of the first number of each $role, and its extents.\nconst ${role}_at = (\n",
                 .end = ")\n",
                 .object = "    $name = (first = $first, extents = ($extents_comma)),\n"},
      .functions = R"(
# The numbers of objects in their order: pack((q = [1, 2], m = [1 2; 3 4]), input_at). An array has the indices of C's, from
# 1 on, and is stored by columns.
function pack(objects, at)
    parts = map(keys(at)) do name
        object, extents = getfield(objects, name), at[name].extents
        size(object) == extents || throw(DimensionMismatch("$$name has extents $$(size(object)), not $$extents"))
        isempty(extents) ? [Float64(object)] : vec(permutedims(Float64.(object), ndims(object):-1:1))
    end
    return reduce(vcat, parts)
end

# The objects of a vector of numbers: unpack(output, output_at).q
function unpack(numbers, at)
    return map(at) do (first, extents)
        isempty(extents) && return numbers[first]
        part = reshape(numbers[first:first + prod(extents) - 1], reverse(extents))
        return permutedims(part, ndims(part):-1:1)
    end
end

)",
      .guards_begin = "\n# The condition of a guard and its places in the source.\nfunction $guard_text(guard)\n"
                      "    text = [\n",
      .guard = "        $text,\n",
      .guards_end = "    ]\n    return get(text, guard, \"\")\nend\n",
      .end = "\nend # module\n",
      .main = R"(
# Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
include("$base.jl")
import .$Module

numbers = Float64[$all_values]
names = [$labels]
given = parse.(Float64, ARGS[1:min(end, length(numbers))])
numbers[1:length(given)] = given
constants = zeros($constants)
output = zeros($outputs)
$Module.$preprocess!(constants, numbers[$inputs + 1:end])
$call
for (name, value) in zip(names, output)
    println(name, " = ", value)
end
)",
      .call = "$Module.$compute!(output, numbers[1:$inputs], constants)",
      .checked_call = R"(guard = $Module.$compute!(output, numbers[1:$inputs], constants)
if guard != 0
    println(stderr, "guard ", guard, " does not hold: ", $Module.$guard_text(guard))
    exit(1)
end)",
  };
  return julia;
}

} // namespace symreal
