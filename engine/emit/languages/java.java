// Helpers of Java, and the code around functions, for java.toml. Marks: language_file.h.

// @helper table_index
// An index outside of its table reads the nearest element.
private static int table_index(double index, int extent) {
  if (!(index > 0)) return 0;
  return index < extent ? (int)index : extent - 1;
}

// @helper joined
private static $real[] joined($real[]... parts) {
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

// @helper fmin
private static double fmin(double x, double y) {
  return x != x ? y : y < x ? y : x;
}

// @helper fmax
private static double fmax(double x, double y) {
  return x != x ? y : y > x ? y : x;
}

// @helper fdim
private static double fdim(double x, double y) {
  return x <= y ? 0 : x - y;
}

// @helper trunc
private static double trunc(double x) {
  return Math.copySign(Math.floor(Math.abs(x)), x);
}

// @helper round
private static double round(double x) {
  double t = trunc(x);
  return Math.abs(x - t) >= 0.5 ? t + Math.signum(x) : t;
}

// @helper logb
private static double logb(double x) {
  if (x == 0) return Double.NEGATIVE_INFINITY;
  if (!Double.isFinite(x)) return x * x;
  return Math.abs(x) < Double.MIN_NORMAL ? Math.getExponent(x * 0x1p54) - 54 : Math.getExponent(x);
}

// @helper asinh
private static double asinh(double x) {
  double a = Math.abs(x);
  double r = a > 1e150 ? Math.log(a) + 0.6931471805599453 : Math.log1p(a + a * a / (1 + Math.sqrt(1 + a * a)));
  return Math.copySign(r, x);
}

// @helper acosh
private static double acosh(double x) {
  if (x < 1) return Double.NaN;
  double t = x - 1;
  return t > 1e150 ? Math.log(x) + 0.6931471805599453 : Math.log1p(t + Math.sqrt(2 * t + t * t));
}

// @helper atanh
private static double atanh(double x) {
  double a = Math.abs(x);
  return Math.copySign(0.5 * Math.log1p(2 * a / (1 - a)), x);
}

// @helper log2
// Exact where x is a power of two.
private static double log2(double x) {
  if (!(x > 0) || Double.isInfinite(x)) return Math.log(x);
  double e = logb(x), m = x < Double.MIN_NORMAL ? x * 0x1p54 * Math.pow(2, -54 - e) : x / Math.pow(2, e);
  return m > 1.4142135623730951 ? e + 1 + Math.log(m / 2) * 1.4426950408889634 : e + Math.log(m) * 1.4426950408889634;
}

// @helper pow
// The base 1 gives 1, as in C.
private static double pow(double x, double y) {
  return x == 1 || (x == -1 && Double.isInfinite(y)) ? 1 : Math.pow(x, y);
}

// @helper erf
// Series about 0; beyond, what is left to 1.
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

// @helper erfc
// A continued fraction, from its end.
private static double erfc(double x) {
  if (x < 0.75) return x < -0.75 ? 2 - erfc(-x) : 1 - erf(x);
  if (!(x < 27.3)) return x != x ? x : 0;
  double f = 0, high = (float)x;
  for (int k = x < 2 ? 250 : 60; k > 0; --k) f = k / 2.0 / (x + f);
  return Math.exp(-high * high) * Math.exp((high - x) * (high + x)) * 0.5641895835477563 / (x + f);
}

// @helper gamma_sum
// Lanczos' approximation, with the coefficients of Godfrey for g = 607/128.
private static double gamma_sum(double x) {
  double[] c = {57.156235665862923517, -59.597960355475491248, 14.136097974741747174, -0.49191381609762019978,
    .33994649984811888699e-4, .46523628927048575665e-4, -.98374475304879564677e-4, .15808870322491248884e-3,
    -.21026444172410488319e-3, .21743961811521264320e-3, -.16431810653676389022e-3, .84418223983852743293e-4,
    -.26190838401581408670e-4, .36899182659531622704e-5};
  double sum = 0.99999999999999709182;
  for (int k = 0; k < c.length; ++k) sum += c[k] / (x + k);
  return sum;
}

// @helper tgamma
private static double tgamma(double x) {
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

// @helper lgamma
private static double lgamma(double x) {
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

// @helper within64
// Beyond 64 bits a conversion gives the least number, whose low bits are 0.
private static double within64(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? x : 0;
}

// @helper to_int32
private static double to_int32(double x) {
  return x > -2147483649.0 && x < 2147483648.0 ? (double)(int)x : -2147483648.0;
}

// @helper to_int64
private static double to_int64(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? (double)(long)x : -0x1p63;
}

// @helper wide_int
private static long wide_int(double x) {
  return x >= -0x1p63 && x < 0x1p63 ? (long)x : Long.MIN_VALUE;
}

// @helper wide_uint
private static long wide_uint(double x) {
  return x >= 0x1p63 ? wide_int(x - 0x1p63) ^ Long.MIN_VALUE : wide_int(x);
}

// @helper wide_uvalue
private static double wide_uvalue(long x) {
  return x >= 0 ? (double)x : (double)((x >>> 1) | (x & 1)) * 2;
}

// @helper wide
private static long wide(double high, double low) {
  return (wide_int(high) << 32) | (wide_int(low) & 0xFFFFFFFFL);
}

// @helper int_div
private static double int_div(double x, double y) {
  double q = x / y;
  return (q < 0 ? Math.ceil(q) : Math.floor(q)) + 0.0;
}

// @helper int_neg
private static double int_neg(double x) {
  return x == 0 ? 0 : -x;
}

// @helper mul_uint32
private static double mul_uint32(double x, double y) {
  return (double)((wide_int(x) * wide_int(y)) & 0xFFFFFFFFL);
}

// @helper wide_div
private static long wide_div(long x, long y) {
  return y == 0 ? 0 : x / y;
}

// @helper wide_rem
private static long wide_rem(long x, long y) {
  return y == 0 ? 0 : x % y;
}

// @helper wide_udiv
private static long wide_udiv(long x, long y) {
  return y == 0 ? 0 : Long.divideUnsigned(x, y);
}

// @helper wide_urem
private static long wide_urem(long x, long y) {
  return y == 0 ? 0 : Long.remainderUnsigned(x, y);
}

// @helper wide_and
private static long wide_and(long x, long y) {
  return x & y;
}

// @helper wide_or
private static long wide_or(long x, long y) {
  return x | y;
}

// @helper wide_xor
private static long wide_xor(long x, long y) {
  return x ^ y;
}

// @helper wide_shl
private static long wide_shl(long x, long n) {
  return x << n;
}

// @helper wide_shr
private static long wide_shr(long x, long n) {
  return x >> n;
}

// @helper wide_ushr
private static long wide_ushr(long x, long n) {
  return x >>> n;
}

// @helper wide_less
private static boolean wide_less(long x, long y) {
  return x < y;
}

// @helper report_value
private static boolean all_finite = true;
private static void report_value(double value, String what) {
  if (all_finite) System.err.println("not finite: " + what + " is " + value);
  all_finite = false;
}

// @text module.index_list
  private static final class Indices_of_$name {
    static final int[] values = {$values};
  }
  public static final int[] $NAME = Indices_of_$name.values;

// @text module.index_part
  private static final class Indices_of_$part {
    static final int[] values = {$values};
  }
  private static final int[] $part = Indices_of_$part.values;

// @text module.structure.begin

  /** The numbers of the $role by their names and indices. */
  public static final class $Role {
    public final $real[] numbers = new $real[$count];

// @text module.structure.object

    public $real $name(int... index) {
      return numbers[place($first, index$more_extents)];
    }
    public void $name($real value, int... index) {
      numbers[place($first, index$more_extents)] = value;
    }

// @text module.functions

  private static int place(int first, int[] index, int... extents) {
    if (index.length != extents.length) throw new IllegalArgumentException(extents.length + " indices are needed");
    int place = 0;
    for (int k = 0; k < index.length; ++k) place = place * extents[k] + java.util.Objects.checkIndex(index[k], extents[k]);
    return first + place;
  }


// @text module.guards_begin

  /** The condition of a guard and its places in the source. */
  public static String $guard_text(int guard) {
    final String[] text = {

// @text module.main

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
