#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"Double",    "Integer", "Long",     "Math",  "Override",   "String",       "System",     "abstract", "assert",
     "boolean",   "break",   "byte",     "case",  "catch",      "char",         "class",      "const",    "continue",
     "default",   "do",      "double",   "else",  "enum",       "extends",      "false",      "final",    "finally",
     "float",     "for",     "goto",     "if",    "implements", "import",       "instanceof", "int",      "interface",
     "long",      "native",  "new",      "null",  "package",    "private",      "protected",  "public",   "return",
     "short",     "static",  "strictfp", "super", "switch",     "synchronized", "this",       "throw",    "throws",
     "transient", "true",    "try",      "var",   "void",       "volatile",     "while",      "yield"});
static_assert(std::ranges::is_sorted(keywords));

static constexpr OperationSpelling spellings[] = {
    {Op::abs, "Math.abs($x)"},
    {Op::fmin, "fmin($x, $y)"},
    {Op::fmax, "fmax($x, $y)"},
    {Op::fdim, "fdim($x, $y)"},
    {Op::fmod, "$x:13%$y:14", 13},
    {Op::remainder, "Math.IEEEremainder($x, $y)"},
    {Op::trunc, "trunc($x)"},
    {Op::round, "round($x)"},
    {Op::copysign, "Math.copySign($x, $y)"},
    {Op::nextafter, "Math.nextAfter($x, $y)"},
    {Op::logb, "logb($x)"},
    {Op::asinh, "asinh($x)"},
    {Op::acosh, "acosh($x)"},
    {Op::atanh, "atanh($x)"},
    {Op::exp2, "Math.pow(2.0, $x)"},
    {Op::log2, "log2($x)"},
    {Op::pow, "pow($x, $y)"},
    {Op::erf, "erf($x)"},
    {Op::erfc, "erfc($x)"},
    {Op::tgamma, "tgamma($x)"},
    {Op::lgamma, "lgamma($x)"},
    {Op::wrap_int8, "($real)(byte)(long)within64($x)", 14},
    {Op::wrap_int16, "($real)(short)(long)within64($x)", 14},
    {Op::wrap_int32, "(double)(int)(long)within64($x)", 14},
    {Op::wrap_uint8, "($real)((long)within64($x) & 255L)", 14},
    {Op::wrap_uint16, "($real)((long)within64($x) & 65535L)", 14},
    {Op::wrap_uint32, "(double)((long)within64($x) & 0xFFFFFFFFL)", 14},
    {Op::wide_uless, "Long.compareUnsigned($x, $y) < 0", 10},
    {Op::wide_value, "(double)$x:14", 14},
    {Op::wide_uvalue, "wide_uvalue($x)"},
    {Op::wide_low, "(double)($x:12 & 0xFFFFFFFFL)", 14},
};

static constexpr Helper helpers[] = {
    {"table_index", R"(// An index outside of its table reads the nearest element.
private static int table_index(double index, int extent) {
  if (!(index > 0)) return 0;
  return index < extent ? (int)index : extent - 1;
}
)"},
    {"joined", R"(private static $real[] joined($real[]... parts) {
  int size = 0;
  for ($real[] part : parts) size += part.length;
  $real[] all = new $real[size];
  int at = 0;
  for ($real[] part : parts) {
    System.arraycopy(part, 0, all, at, part.length);
    at += part.length;
  }
  return all;
}
)"},
    {"fmin", R"(private static double fmin(double x, double y) {
  return x != x ? y : y < x ? y : x;
}
)"},
    {"fmax", R"(private static double fmax(double x, double y) {
  return x != x ? y : y > x ? y : x;
}
)"},
    {"fdim", R"(private static double fdim(double x, double y) {
  return x <= y ? 0 : x - y;
}
)"},
    {"trunc", R"(private static double trunc(double x) {
  return Math.copySign(Math.floor(Math.abs(x)), x);
}
)"},
    {"round", R"(private static double round(double x) {
  double t = trunc(x);
  return Math.abs(x - t) >= 0.5 ? t + Math.signum(x) : t;
}
)"},
    {"logb", R"(private static double logb(double x) {
  if (x == 0) return Double.NEGATIVE_INFINITY;
  if (!Double.isFinite(x)) return x * x;
  return Math.abs(x) < Double.MIN_NORMAL ? Math.getExponent(x * 0x1p54) - 54 : Math.getExponent(x);
}
)"},
    {"asinh", R"(private static double asinh(double x) {
  double a = Math.abs(x);
  double r = a > 1e150 ? Math.log(a) + 0.6931471805599453 : Math.log1p(a + a * a / (1 + Math.sqrt(1 + a * a)));
  return Math.copySign(r, x);
}
)"},
    {"acosh", R"(private static double acosh(double x) {
  if (x < 1) return Double.NaN;
  double t = x - 1;
  return t > 1e150 ? Math.log(x) + 0.6931471805599453 : Math.log1p(t + Math.sqrt(2 * t + t * t));
}
)"},
    {"atanh", R"(private static double atanh(double x) {
  double a = Math.abs(x);
  return Math.copySign(0.5 * Math.log1p(2 * a / (1 - a)), x);
}
)"},
    {"log2", R"(// Exact where x is a power of two.
private static double log2(double x) {
  if (!(x > 0) || Double.isInfinite(x)) return Math.log(x);
  double e = logb(x), m = x < Double.MIN_NORMAL ? x * 0x1p54 * Math.pow(2, -54 - e) : x / Math.pow(2, e);
  return m > 1.4142135623730951 ? e + 1 + Math.log(m / 2) * 1.4426950408889634 : e + Math.log(m) * 1.4426950408889634;
}
)"},
    {"pow", R"(// The base 1 gives 1, as in C.
private static double pow(double x, double y) {
  return x == 1 || (x == -1 && Double.isInfinite(y)) ? 1 : Math.pow(x, y);
}
)"},
    {"erf", R"(// Series about 0; beyond, what is left to 1.
private static double erf(double x) {
  if (Math.abs(x) < 1e-8) return x * 1.1283791670955126;
  if (!(Math.abs(x) < 0.75)) return x != x ? x : x > 0 ? 1 - erfc(x) : erfc(-x) - 1;
  double term = x, sum = x;
  for (int k = 1; k < 30; ++k) {
    term *= -x * x / k;
    sum += term / (2 * k + 1);
  }
  return sum * 1.1283791670955126;
}
)"},
    {"erfc", R"(// A continued fraction, from its end.
private static double erfc(double x) {
  if (x < 0.75) return x < -0.75 ? 2 - erfc(-x) : 1 - erf(x);
  if (!(x < 27.3)) return x != x ? x : 0;
  double f = 0, high = (float)x;
  for (int k = x < 2 ? 250 : 60; k > 0; --k) f = k / 2.0 / (x + f);
  return Math.exp(-high * high) * Math.exp((high - x) * (high + x)) * 0.5641895835477563 / (x + f);
}
)"},
    {"gamma_sum", R"(// Lanczos' approximation, with the coefficients of Godfrey for g = 607/128.
private static double gamma_sum(double x) {
  double[] c = {57.156235665862923517, -59.597960355475491248, 14.136097974741747174, -0.49191381609762019978,
    .33994649984811888699e-4, .46523628927048575665e-4, -.98374475304879564677e-4, .15808870322491248884e-3,
    -.21026444172410488319e-3, .21743961811521264320e-3, -.16431810653676389022e-3, .84418223983852743293e-4,
    -.26190838401581408670e-4, .36899182659531622704e-5};
  double sum = 0.99999999999999709182;
  for (int k = 0; k < c.length; ++k) sum += c[k] / (x + k);
  return sum;
}
)"},
    {"tgamma", R"(private static double tgamma(double x) {
  if (x == 0) return 1 / x;
  if (x < 0.5) {
    if (x == Math.floor(x)) return Double.NaN;
    double r = x - 2 * Math.rint(x / 2);
    return Math.PI / (Math.sin(Math.PI * r) * tgamma(1 - x));
  }
  if (x > 171.7) return Double.POSITIVE_INFINITY;
  if (x == Math.floor(x) && x < 24) {
    double product = 1;
    for (int k = 2; k < x; ++k) product *= k;
    return product;
  }
  double t = x + 607.0 / 128 - 0.5, root = Math.pow(t, x / 2 - 0.25);
  return 2.5066282746310005 * gamma_sum(x) * root * Math.exp(-t) * root;
}
)"},
    {"lgamma", R"(private static double lgamma(double x) {
  if (Double.isInfinite(x)) return Double.POSITIVE_INFINITY;
  if (Math.abs(x) < 1e-200) return -Math.log(Math.abs(x));
  if (x < 0.5) {
    if (x == Math.floor(x)) return Double.POSITIVE_INFINITY;
    double r = x - 2 * Math.rint(x / 2);
    return Math.log(Math.PI / Math.abs(Math.sin(Math.PI * r))) - lgamma(1 - x);
  }
  if (x < 20) return Math.log(tgamma(x));
  double z = 1 / (x * x);
  return (x - 0.5) * Math.log(x) - x + 0.9189385332046728
      + (1.0 / 12 - z * (1.0 / 360 - z * (1.0 / 1260 - z / 1680))) / x;
}
)"},
    {"within64", R"(// Beyond 64 bits a conversion gives the least number, whose low bits are 0.
private static double within64(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? x : 0;
}
)"},
    {"to_int32", R"(private static double to_int32(double x) {
  return x > -2147483649.0 && x < 2147483648.0 ? (double)(int)x : -2147483648.0;
}
)"},
    {"to_int64", R"(private static double to_int64(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? (double)(long)x : -0x1p63;
}
)"},
    {"wide_int", R"(private static long wide_int(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? (long)x : Long.MIN_VALUE;
}
)"},
    {"wide_uint", R"(private static long wide_uint(double x) {
  return x >= 0x1p63 ? wide_int(x - 0x1p63) ^ Long.MIN_VALUE : wide_int(x);
}
)"},
    {"wide_uvalue", R"(private static double wide_uvalue(long x) {
  return x >= 0 ? (double)x : (double)((x >>> 1) | (x & 1)) * 2;
}
)"},
    {"wide", R"(private static long wide(double high, double low) {
  return (wide_int(high) << 32) | (wide_int(low) & 0xFFFFFFFFL);
}
)"},
    {"int_div", R"(private static double int_div(double x, double y) {
  double q = x / y;
  return (q < 0 ? Math.ceil(q) : Math.floor(q)) + 0.0;
}
)"},
    {"int_neg", R"(private static double int_neg(double x) {
  return x == 0 ? 0 : -x;
}
)"},
    {"mul_uint32", R"(private static double mul_uint32(double x, double y) {
  return (double)((wide_int(x) * wide_int(y)) & 0xFFFFFFFFL);
}
)"},
    {"wide_div", R"(private static long wide_div(long x, long y) {
  return y == 0 ? 0 : x / y;
}
)"},
    {"wide_rem", R"(private static long wide_rem(long x, long y) {
  return y == 0 ? 0 : x % y;
}
)"},
    {"wide_udiv", R"(private static long wide_udiv(long x, long y) {
  return y == 0 ? 0 : Long.divideUnsigned(x, y);
}
)"},
    {"wide_urem", R"(private static long wide_urem(long x, long y) {
  return y == 0 ? 0 : Long.remainderUnsigned(x, y);
}
)"},
    {"wide_and", "private static long wide_and(long x, long y) {\n  return x & y;\n}\n"},
    {"wide_or", "private static long wide_or(long x, long y) {\n  return x | y;\n}\n"},
    {"wide_xor", "private static long wide_xor(long x, long y) {\n  return x ^ y;\n}\n"},
    {"wide_shl", "private static long wide_shl(long x, long n) {\n  return x << n;\n}\n"},
    {"wide_shr", "private static long wide_shr(long x, long n) {\n  return x >> n;\n}\n"},
    {"wide_ushr", "private static long wide_ushr(long x, long n) {\n  return x >>> n;\n}\n"},
    {"wide_less", "private static boolean wide_less(long x, long y) {\n  return x < y;\n}\n"},
    {"report_value", R"(private static boolean all_finite = true;
private static void report_value(double value, String what) {
  if (all_finite) System.err.println("not finite: " + what + " is " + value);
  all_finite = false;
}
)"},
};

static constexpr Companion beside[] = {{"_main.java", module_main, "mainline"}};

static constexpr Op overloaded[] = {Op::abs, Op::fma, Op::copysign, Op::nextafter};
static constexpr Word words[] = {{"Real", "Double", "Float"}}; // the class of numbers

Language language_java() {
  Language java;
  java.names = {keywords, false};
  java.comment = {"// ", "// ", ""};
  java.lines = {.width = 100, .least = 60, .base = 2};
  java.numbers = {"Double.NaN", "Double.NaN", "Double.POSITIVE_INFINITY", "Double.NEGATIVE_INFINITY"};
  java.number = {"double", "0.0"};
  java.truth = {"boolean", "false"};
  java.wide = {"long", "0L"};
  java.single = {
      .number = {"float", "0.0f"},
      .numbers = {"Float.NaN", "Float.NaN", "Float.POSITIVE_INFINITY", "Float.NEGATIVE_INFINITY", "e", "f", "", "f"},
      .narrowed = "(float)",
      .given = overloaded};
  java.words = words;
  java.expressions = {
      .call_prefix = "Math.",
      .operations = spellings,
      .element = "$array[$index]",
      .yes = "true",
      .truth_as_number = "($x ? 1.0$suffix : 0.0$suffix)",
      .small_integer = "${value}L",
      .large_integer = "${signed}L",
      .kept_integer = "Double.doubleToRawLongBits($element)",
      .table_index = "table_index($index, $extent)",
  };
  java.statements = {
      .variable = "$type $name = $value;",
      .constant = "final $type $name = $value;",
      .set = "$name = $value;",
      .keep_integer = "$element = Double.longBitsToDouble($value);",
      .array = "final $real[] $name = new $real[$count];",
      .zero_array = "final $real[] $name = new $real[$count];",
      .open = "if ($condition) {",
      .otherwise = "} else {",
      .close = "}",
      .check = "if ($condition) return $number;",
      .value_check = "if (!$Real.isFinite($name)) report_value($name, \"$text\");",
      .value_check_begin = "all_finite = true;",
  };
  java.functions = {
      .head = "public static $result $name($parameters) {",
      .local_head = "static $result $name($parameters) {",
      .end = "}",
      .no_result = "void",
      .status = "int",
      .input = "$real[] $name",
      .output = "$real[] $name",
      .success = "return 0;",
      .failed = "int failed;",
      .call = "$group.$name($arguments);",
      .checked_call = "failed = $group.$name($arguments);\nif (failed != 0) return failed;",
      .parts_store = true,
      .most_statements = 80,                               // HotSpot compiles methods of at most 8000 bytes
      .group_begin = "private static final class $name {", // a class may have 65535 constants
      .group_end = "}",
      .group_size = 25,
  };
  java.tables = {
      .begin = "private static final class Values_of_$name {\n  static final $real[] values = {",
      .end = "};\n}\nprivate static final $real[] $name = Values_of_$name.values;",
      .most_values = 4000, // a method may have 64 KB
      .joined = "private static final $real[] $name = joined($parts);\n",
  };
  java.files = {
      .extension = ".java",
      .kept_when = ", but for the functions of\nMath, which each machine has in its own way",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  java.module = {
      .indent = 2,
      .is_named_after_file = true,
      .begin = "public final class $unit {\n  private $unit() {}\n\n",
      .size = "  public static final int $NAME = $value;\n",
      .index_list = "  private static final class Indices_of_$name {\n    static final int[] values = {$values};\n  }\n"
                    "  public static final int[] $NAME = Indices_of_$name.values;\n",
      .most_indices = 4000, // a method may have 64 KB
      .index_part = "  private static final class Indices_of_$part {\n    static final int[] values = {$values};\n  }\n"
                    "  private static final int[] $part = Indices_of_$part.values;\n",
      .joined_indices = "  public static final int[] $NAME = java.util.stream.Stream.of($parts)\n"
                        "    .flatMapToInt(java.util.Arrays::stream).toArray();\n",
      .structure = {.begin =
                        "\n  /** The numbers of the $role by their names and indices. */\n"
                        "  public static final class $Role {\n    public final $real[] numbers = new $real[$count];\n",
                    .end = "  }\n",
                    .object = R"(
    public $real $name(int... index) {
      return numbers[place($first, index$more_extents)];
    }
    public void $name($real value, int... index) {
      numbers[place($first, index$more_extents)] = value;
    }
)"},
      .functions = R"(
  private static int place(int first, int[] index, int... extents) {
    if (index.length != extents.length) throw new IllegalArgumentException(extents.length + " indices are needed");
    int place = 0;
    for (int k = 0; k < index.length; ++k) place = place * extents[k] + java.util.Objects.checkIndex(index[k], extents[k]);
    return first + place;
  }

)",
      .guards_begin = "\n  /** The condition of a guard and its places in the source. */\n"
                      "  public static String $guard_text(int guard) {\n    final String[] text = {\n",
      .guard = "      $text,\n",
      .guards_end = "    };\n    return guard > 0 && guard <= text.length ? text[guard - 1] : \"\";\n  }\n",
      .end = "}\n",
      .main = R"(
/** Runs the kernel once and prints its outputs. */
public final class ${unit}_main {
  private ${unit}_main() {}

  private static $real read(String text) {
    return $Real.parse$Real(text.replace("inf", "Infinity").replace("nan", "NaN"));
  }

  private static String shown($real x) {
    return $Real.toString(x).replace("Infinity", "inf").replace("NaN", "nan");
  }

  /** Arguments replace the recorded inputs in order, then the parameters. */
  public static void main(String[] arguments) {
    final $real[] input = {$input_values};
    final $real[] parameters = {$parameter_values};
    final String[] names = {$labels};
    final $real[] constants = new $real[$constants], output = new $real[$outputs];
    for (int i = 0; i < arguments.length; ++i)
      if (i < input.length) input[i] = read(arguments[i]);
      else if (i < input.length + parameters.length) parameters[i - input.length] = read(arguments[i]);
    $unit.$preprocess(parameters, constants);
    $call
    for (int i = 0; i < output.length; ++i) System.out.println(names[i] + " = " + shown(output[i]));
  }
}
)",
      .call = "$unit.$compute(input, constants, output);",
      .checked_call = R"(final int guard = $unit.$compute(input, constants, output);
    if (guard != 0) {
      System.err.println("guard " + guard + " does not hold: " + $unit.$guard_text(guard));
      System.exit(1);
    })",
  };
  return java;
}

} // namespace symreal
