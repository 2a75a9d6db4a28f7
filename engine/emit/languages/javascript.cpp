#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"BigInt",    "Infinity", "Math",      "NaN",   "Number",     "arguments", "async",    "await",
     "break",     "case",     "catch",     "class", "const",      "continue",  "debugger", "default",
     "delete",    "do",       "else",      "enum",  "eval",       "export",    "extends",  "false",
     "finally",   "for",      "function",  "if",    "implements", "import",    "in",       "instanceof",
     "interface", "let",      "new",       "null",  "of",         "package",   "private",  "protected",
     "public",    "return",   "static",    "super", "switch",     "this",      "throw",    "true",
     "try",       "typeof",   "undefined", "var",   "void",       "while",     "with",     "yield"});
static_assert(std::ranges::is_sorted(keywords));

static constexpr OperationSpelling spellings[] = {
    {Op::fmod, "$x:13%$y:14", 13},
    {Op::fmin, "fmin($x, $y)"},
    {Op::fmax, "fmax($x, $y)"},
    {Op::fdim, "fdim($x, $y)"},
    {Op::abs, "Math.abs($x)"},
    {Op::fma, "fma($x, $y, $z)"},
    {Op::remainder, "remainder($x, $y)"},
    {Op::round, "round($x)"},
    {Op::rint, "rint($x)"},
    {Op::copysign, "copysign($x, $y)"},
    {Op::nextafter, "nextafter($x, $y)"},
    {Op::logb, "logb($x)"},
    {Op::exp2, "Math.pow(2.0, $x)"},
    {Op::pow, "pow($x, $y)"},
    {Op::erf, "erf($x)"},
    {Op::erfc, "erfc($x)"},
    {Op::tgamma, "tgamma($x)"},
    {Op::lgamma, "lgamma($x)"},
    {Op::f32, "Math.fround($x)"},
    {Op::wrap_int8, "(within64($x) << 24 >> 24)"},
    {Op::wrap_int16, "(within64($x) << 16 >> 16)"},
    {Op::wrap_int32, "(within64($x) | 0)"},
    {Op::wrap_uint8, "(within64($x) & 255)"},
    {Op::wrap_uint16, "(within64($x) & 65535)"},
    {Op::wrap_uint32, "(within64($x) >>> 0)"},
    {Op::wide_add, "BigInt.asUintN(64, $x + $y)"},
    {Op::wide_sub, "BigInt.asUintN(64, $x - $y)"},
    {Op::wide_mul, "BigInt.asUintN(64, $x * $y)"},
    {Op::wide_equal, "$x:12 === $y:12", 9},
    {Op::wide_value, "Number(BigInt.asIntN(64, $x))"},
    {Op::wide_uvalue, "Number($x)"},
    {Op::wide_low, "Number($x:14 & 0xffffffffn)"},
    {Op::eq, "$x:12 === $y:12", 9},
    {Op::ne, "$x:12 !== $y:12", 9},
};

static constexpr Helper helpers[] = {
    {"table_index", R"(// An index outside of its table reads the nearest element.
function table_index(index, extent) {
  if (!(index > 0)) return 0;
  return index < extent ? Math.trunc(index) : extent - 1;
}
)"},
    {"bits", R"(const bits = new DataView(new ArrayBuffer(8));
)"},
    {"to_bits", R"(function to_bits(x) {
  bits.setFloat64(0, x);
  return bits.getBigUint64(0);
}
)"},
    {"from_bits", R"(function from_bits(x) {
  bits.setBigUint64(0, x);
  return bits.getFloat64(0);
}
)"},
    {"fmin", R"(function fmin(x, y) {
  if (x !== x) return y;
  return y < x ? y : x;
}
)"},
    {"fmax", R"(function fmax(x, y) {
  if (x !== x) return y;
  return y > x ? y : x;
}
)"},
    {"fdim", R"(function fdim(x, y) {
  return x <= y ? 0 : x - y;
}
)"},
    {"pow", R"(// The base 1 and the exponent 0 give 1, as in C.
function pow(x, y) {
  if (x === 1 || (x === -1 && (y === Infinity || y === -Infinity))) return 1;
  return Math.pow(x, y);
}
)"},
    {"remainder", R"(function remainder(x, y) {
  y = Math.abs(y);
  if (!(y > 0) || x !== x || x === Infinity || x === -Infinity) return NaN;
  if (y === Infinity) return x;
  let r = Math.abs(x) % y, odd = false;
  if (y < 8.98846567431158e307) {
    const q = Math.abs(x) % (2 * y);
    odd = q >= y;
  }
  const twice = r - (y - r);
  if (twice > 0 || (twice === 0 && odd)) r -= y;
  return x < 0 || Object.is(x, -0) ? -r : r;
}
)"},
    {"round", R"(function round(x) {
  const t = Math.trunc(x);
  return Math.abs(x - t) >= 0.5 ? t + Math.sign(x) : t;
}
)"},
    {"rint", R"(function rint(x) {
  const a = Math.abs(x);
  if (!(a < 4503599627370496)) return x;
  return copysign(a + 4503599627370496 - 4503599627370496, x);
}
)"},
    {"copysign", R"(function copysign(x, y) {
  const negative = y < 0 || Object.is(y, -0);
  return negative ? -Math.abs(x) : Math.abs(x);
}
)"},
    {"nextafter", R"(function nextafter(x, y) {
  if (x !== x || y !== y) return NaN;
  if (x === y) return y;
  if (x === 0) return y > 0 ? 5e-324 : -5e-324;
  return from_bits(to_bits(x) + (x < y === x > 0 ? 1n : -1n));
}
)"},
    {"logb", R"(function logb(x) {
  if (x === 0) return -Infinity;
  if (x !== x || x === Infinity || x === -Infinity) return x * x;
  const exponent = (to_bits(x) >> 52n) & 2047n;
  return exponent === 0n ? logb(x * 18014398509481984) - 54 : Number(exponent) - 1023;
}
)"},
    {"fma", R"(// Numbers as integers times a power of two.
function fma(x, y, z) {
  if (!Number.isFinite(x) || !Number.isFinite(y) || x === 0 || y === 0) return x * y + z;
  if (!Number.isFinite(z)) return z;
  if (z === 0 && Math.abs(x * y) > 1e-290) return x * y;
  const split = (a) => {
    const b = to_bits(a), e = Number((b >> 52n) & 2047n);
    const m = (b & 4503599627370495n) | (e === 0 ? 0n : 4503599627370496n);
    return [a < 0 ? -m : m, (e === 0 ? 1 : e) - 1075];
  };
  const [mx, ex] = split(x), [my, ey] = split(y), [mz, ez] = split(z);
  let m = mx * my, e = ex + ey;
  if (e > ez) {
    m = (m << BigInt(e - ez)) + mz;
    e = ez;
  } else {
    m += mz << BigInt(ez - e);
  }
  if (m === 0n) return 0;
  const a = m < 0n ? -m : m, length = a.toString(2).length;
  const drop = Math.max(length - 53, -1074 - e);
  let value = a;
  if (drop > 0) {
    const d = BigInt(drop), rest = a & ((1n << d) - 1n), half = 1n << (d - 1n);
    value = a >> d;
    if (rest > half || (rest === half && (value & 1n) === 1n)) value += 1n;
    e += drop;
  }
  let r = Number(value);
  for (; e > 1000; e -= 1000) r *= 2 ** 1000;
  for (; e < -1000; e += 1000) r *= 2 ** -1000;
  r *= 2 ** e;
  return m < 0n ? -r : r;
}
)"},
    {"erf", R"(// Series about 0; beyond, what is left to 1.
function erf(x) {
  const a = Math.abs(x);
  if (a < 1e-8) return x * 1.1283791670955126;
  if (!(a < 0.75)) return x !== x ? x : x > 0 ? 1 - erfc(x) : erfc(-x) - 1;
  let term = x, sum = x;
  for (let k = 1; k < 30; ++k) {
    term *= -x * x / k;
    sum += term / (2 * k + 1);
  }
  return sum * 1.1283791670955126;
}
)"},
    {"erfc", R"(// A continued fraction, from its end.
function erfc(x) {
  if (x < 0.75) return x < -0.75 ? 2 - erfc(-x) : 1 - erf(x);
  if (!(x < 27.3)) return x !== x ? x : 0;
  const x2 = x * x;
  let f = 0;
  for (let k = x < 2 ? 250 : 60; k > 0; --k) f = k / 2 / (x + f);
  const high = Math.fround(x);
  return Math.exp(-high * high) * Math.exp((high - x) * (high + x)) * 0.5641895835477563 / (x + f);
}
)"},
    {"gamma_sum", R"(// Lanczos' approximation, with the coefficients of Godfrey for g = 607/128.
function gamma_sum(x) {
  const c = [57.156235665862923517, -59.597960355475491248, 14.136097974741747174, -0.49191381609762019978,
    .33994649984811888699e-4, .46523628927048575665e-4, -.98374475304879564677e-4, .15808870322491248884e-3,
    -.21026444172410488319e-3, .21743961811521264320e-3, -.16431810653676389022e-3, .84418223983852743293e-4,
    -.26190838401581408670e-4, .36899182659531622704e-5];
  let sum = 0.99999999999999709182;
  for (let k = 0; k < c.length; ++k) sum += c[k] / (x + k);
  return sum;
}
)"},
    {"tgamma", R"(function tgamma(x) {
  if (x === 0) return 1 / x;
  if (x < 0.5) {
    if (x === Math.floor(x)) return NaN;
    const r = x - 2 * Math.round(x / 2);
    return Math.PI / (Math.sin(Math.PI * r) * tgamma(1 - x));
  }
  if (x > 171.7) return Infinity;
  if (x === Math.floor(x) && x < 24) {
    let product = 1;
    for (let k = 2; k < x; ++k) product *= k;
    return product;
  }
  const t = x + 607 / 128 - 0.5, root = Math.pow(t, x / 2 - 0.25);
  return 2.5066282746310005 * gamma_sum(x) * root * Math.exp(-t) * root;
}
)"},
    {"lgamma", R"(function lgamma(x) {
  if (x === Infinity || x === -Infinity) return Infinity;
  if (Math.abs(x) < 1e-200) return -Math.log(Math.abs(x));
  if (x < 0.5) {
    if (x === Math.floor(x)) return Infinity;
    const r = x - 2 * Math.round(x / 2);
    return Math.log(Math.PI / Math.abs(Math.sin(Math.PI * r))) - lgamma(1 - x);
  }
  if (x < 20) return Math.log(tgamma(x));
  const z = 1 / (x * x);
  return (x - 0.5) * Math.log(x) - x + 0.9189385332046728 + (1 / 12 - z * (1 / 360 - z * (1 / 1260 - z / 1680))) / x;
}
)"},
    {"within64", R"(// Beyond 64 bits a conversion gives the least number, whose low bits are 0.
function within64(x) {
  return x >= -9223372036854775808 && x < 9223372036854775808 ? x : 0;
}
)"},
    {"to_int32", R"(function to_int32(x) {
  return x > -2147483649 && x < 2147483648 ? Math.trunc(x) + 0 : -2147483648;
}
)"},
    {"to_int64", R"(function to_int64(x) {
  return x >= -9223372036854775808 && x < 9223372036854775808 ? Math.trunc(x) + 0 : -9223372036854775808;
}
)"},
    {"wide_int", R"(function wide_int(x) {
  return BigInt.asUintN(64, BigInt(to_int64(x)));
}
)"},
    {"wide_uint", R"(function wide_uint(x) {
  return x >= 9223372036854775808 ? wide_int(x - 9223372036854775808) ^ 9223372036854775808n : wide_int(x);
}
)"},
    {"wide", R"(function wide(high, low) {
  return BigInt.asUintN(64, wide_int(high) << 32n) | (wide_int(low) & 0xffffffffn);
}
)"},
    {"int_div", R"(function int_div(x, y) {
  return Math.trunc(x / y) + 0;
}
)"},
    {"int_neg", R"(function int_neg(x) {
  return x === 0 ? 0 : -x;
}
)"},
    {"mul_uint32", R"(function mul_uint32(x, y) {
  return Math.imul(within64(x), within64(y)) >>> 0;
}
)"},
    {"wide_div", R"(function wide_div(x, y) {
  return y === 0n ? 0n : BigInt.asUintN(64, BigInt.asIntN(64, x) / BigInt.asIntN(64, y));
}
)"},
    {"wide_rem", R"(function wide_rem(x, y) {
  return y === 0n ? 0n : BigInt.asUintN(64, BigInt.asIntN(64, x) % BigInt.asIntN(64, y));
}
)"},
    {"wide_udiv", R"(function wide_udiv(x, y) {
  return y === 0n ? 0n : x / y;
}
)"},
    {"wide_urem", R"(function wide_urem(x, y) {
  return y === 0n ? 0n : x % y;
}
)"},
    {"wide_and", "function wide_and(x, y) {\n  return x & y;\n}\n"},
    {"wide_or", "function wide_or(x, y) {\n  return x | y;\n}\n"},
    {"wide_xor", "function wide_xor(x, y) {\n  return x ^ y;\n}\n"},
    {"wide_shl", "function wide_shl(x, n) {\n  return BigInt.asUintN(64, x << (n & 63n));\n}\n"},
    {"wide_shr", "function wide_shr(x, n) {\n  return BigInt.asUintN(64, BigInt.asIntN(64, x) >> (n & 63n));\n}\n"},
    {"wide_ushr", "function wide_ushr(x, n) {\n  return x >> (n & 63n);\n}\n"},
    {"wide_less", "function wide_less(x, y) {\n  return BigInt.asIntN(64, x) < BigInt.asIntN(64, y);\n}\n"},
    {"report_value", R"(let all_finite = true;
function report_value(value, what) {
  if (all_finite) console.error("not finite: " + what + " is " + value);
  all_finite = false;
}
)"},
};

static constexpr Companion beside[] = {{"_main.mjs", module_main, "mainline"}};

Language language_javascript() {
  Language js;
  js.names = {keywords, false};
  js.comment = {"// ", "// ", ""};
  js.lines = {.width = 100, .least = 60};
  js.numbers = {"NaN", "NaN", "Infinity", "-Infinity"};
  js.number = {"let", "0.0"};
  js.truth = {"let", "false"};
  js.wide = {"let", "0n"};
  js.expressions = {
      .call_prefix = "Math.",
      .operations = spellings,
      .element = "$array[$index]",
      .yes = "true",
      .truth_as_number = "Number($x)",
      .small_integer = "${value}n",
      .large_integer = "${value}n",
      .kept_integer = "to_bits($element)",
      .table_index = "table_index($index, $extent)",
  };
  js.statements = {
      .variable = "let $name = $value;",
      .constant = "const $name = $value;",
      .set = "$name = $value;",
      .keep_integer = "$element = from_bits($value);",
      .array = "const $name = new Float64Array($count);",
      .zero_array = "const $name = new Float64Array($count);",
      .open = "if ($condition) {",
      .otherwise = "} else {",
      .close = "}",
      .check = "if ($condition) return $number;",
      .value_check = "if (!Number.isFinite($name)) report_value($name, \"$text\");",
      .value_check_begin = "all_finite = true;",
  };
  js.functions = {
      .head = "export function $name($parameters) {",
      .local_head = "function $name($parameters) {",
      .end = "}",
      .input = "$name",
      .output = "$name",
      .success = "return 0;",
      .failed = "let failed = 0;",
      .call = "$name($arguments);",
      .checked_call = "failed = $name($arguments);\nif (failed !== 0) return failed;",
      .parts_store = true,
  };
  js.tables = {.begin = "const $name = [", .end = "];"};
  js.files = {
      .extension = ".mjs",
      .kept_when = ", but for the functions of\nMath, which each engine has in its own way",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  js.module = {
      .begin = "\n",
      .size = "export const $name = $value;\n",
      .index_list = "export const $name = Int32Array.of($values);\n",
      .places =
          {.begin = "\n// The index of the first number of each $role, and its extents.\nexport const ${role}_at = {\n",
           .end = "};\n",
           .object = "  $name: { first: $first, extents: [$extents] },\n"},
      .functions = R"(
// The numbers of objects in their order: pack({ q: [1, 2], m: [[1, 2], [3, 4]] }, input_at)
export function pack(objects, at) {
  const numbers = Object.keys(at).map((name) => {
    if (!(name in objects)) throw new RangeError("there is no '" + name + "'");
    const values = [objects[name]].flat(Infinity), count = at[name].extents.reduce((x, y) => x * y, 1);
    if (values.length !== count) throw new RangeError("'" + name + "' has " + values.length + " numbers, not " + count);
    return values;
  });
  return Float64Array.from(numbers.flat());
}

// The objects of an array of numbers: unpack(output, output_at).q
export function unpack(numbers, at) {
  const shaped = (first, extents) => {
    if (extents.length === 0) return numbers[first];
    const size = extents.slice(1).reduce((x, y) => x * y, 1);
    return Array.from({ length: extents[0] }, (_, i) => shaped(first + i * size, extents.slice(1)));
  };
  return Object.fromEntries(Object.entries(at).map(([name, { first, extents }]) => [name, shaped(first, extents)]));
}

)",
      .guards_begin =
          "\n// The condition of a guard and its places in the source.\nexport function $guard_text(guard) {\n"
          "  const text = [\n",
      .guard = "    $text,\n",
      .guards_end = "  ];\n  return text[guard - 1] ?? \"\";\n}\n",
      .main = R"(import * as kernel from "./$base.mjs";

// Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
const input = [$input_values];
const parameters = [$parameter_values];
const names = [$labels];
const constants = new Float64Array($constants);
const output = new Float64Array($outputs);
const read = (text) => text.endsWith("inf") ? Number(text.replace("inf", "Infinity")) : Number(text);
process.argv.slice(2).forEach((argument, i) => {
  if (i < input.length) input[i] = read(argument);
  else if (i < input.length + parameters.length) parameters[i - input.length] = read(argument);
});
kernel.$preprocess(parameters, constants);
$call
const show = (x) => Object.is(x, -0) ? "-0" : String(x).replace("Infinity", "inf").replace("NaN", "nan");
names.forEach((name, i) => console.log(name + " = " + show(output[i])));
)",
      .call = "kernel.$compute(input, constants, output);",
      .checked_call = R"(const guard = kernel.$compute(input, constants, output);
if (guard !== 0) {
  console.error("guard " + guard + " does not hold: " + kernel.$guard_text(guard));
  process.exit(1);
})",
  };
  return js;
}

} // namespace symreal
