// Helpers of JavaScript, and the code around functions, for javascript.toml. Marks: language_file.h.

// @helper table_index
// An index outside of its table reads the nearest element.
function table_index(index, extent) {
  if (!(index > 0)) return 0;
  return index < extent ? Math.trunc(index) : extent - 1;
}

// @helper bits
const bits = new DataView(new ArrayBuffer(8));

// @helper to_bits
function to_bits(x) {
  bits.setFloat64(0, x);
  return bits.getBigUint64(0);
}

// @helper from_bits
function from_bits(x) {
  bits.setBigUint64(0, x);
  return bits.getFloat64(0);
}

// @helper fmin
function fmin(x, y) {
  if (x !== x) return y;
  return y < x ? y : x;
}

// @helper fmax
function fmax(x, y) {
  if (x !== x) return y;
  return y > x ? y : x;
}

// @helper fdim
function fdim(x, y) {
  return x <= y ? 0 : x - y;
}

// @helper pow
// The base 1 and the exponent 0 give 1, as in C.
function pow(x, y) {
  if (x === 1 || (x === -1 && (y === Infinity || y === -Infinity))) return 1;
  return Math.pow(x, y);
}

// @helper remainder
function remainder(x, y) {
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

// @helper round
function round(x) {
  const t = Math.trunc(x);
  return Math.abs(x - t) >= 0.5 ? t + Math.sign(x) : t;
}

// @helper rint
function rint(x) {
  const a = Math.abs(x);
  if (!(a < 4503599627370496)) return x;
  return copysign(a + 4503599627370496 - 4503599627370496, x);
}

// @helper copysign
function copysign(x, y) {
  const negative = y < 0 || Object.is(y, -0);
  return negative ? -Math.abs(x) : Math.abs(x);
}

// @helper nextafter
function nextafter(x, y) {
  if (x !== x || y !== y) return NaN;
  if (x === y) return y;
  if (x === 0) return y > 0 ? 5e-324 : -5e-324;
  return from_bits(to_bits(x) + (x < y === x > 0 ? 1n : -1n));
}

// @helper logb
function logb(x) {
  if (x === 0) return -Infinity;
  if (x !== x || x === Infinity || x === -Infinity) return x * x;
  const exponent = (to_bits(x) >> 52n) & 2047n;
  return exponent === 0n ? logb(x * 18014398509481984) - 54 : Number(exponent) - 1023;
}

// @helper fma
// Numbers as integers times a power of two.
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

// @helper erf
// Series about 0; beyond, what is left to 1.
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

// @helper erfc
// A continued fraction, from its end.
function erfc(x) {
  if (x < 0.75) return x < -0.75 ? 2 - erfc(-x) : 1 - erf(x);
  if (!(x < 27.3)) return x !== x ? x : 0;
  const x2 = x * x;
  let f = 0;
  for (let k = x < 2 ? 250 : 60; k > 0; --k) f = k / 2 / (x + f);
  const high = Math.fround(x);
  return Math.exp(-high * high) * Math.exp((high - x) * (high + x)) * 0.5641895835477563 / (x + f);
}

// @helper gamma_sum
// Lanczos' approximation, with the coefficients of Godfrey for g = 607/128.
function gamma_sum(x) {
  const c = [57.156235665862923517, -59.597960355475491248, 14.136097974741747174, -0.49191381609762019978,
    .33994649984811888699e-4, .46523628927048575665e-4, -.98374475304879564677e-4, .15808870322491248884e-3,
    -.21026444172410488319e-3, .21743961811521264320e-3, -.16431810653676389022e-3, .84418223983852743293e-4,
    -.26190838401581408670e-4, .36899182659531622704e-5];
  let sum = 0.99999999999999709182;
  for (let k = 0; k < c.length; ++k) sum += c[k] / (x + k);
  return sum;
}

// @helper tgamma
function tgamma(x) {
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

// @helper lgamma
function lgamma(x) {
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

// @helper within64
// Beyond 64 bits a conversion gives the least number, whose low bits are 0.
function within64(x) {
  return x >= -9223372036854775808 && x < 9223372036854775808 ? x : 0;
}

// @helper to_int32
function to_int32(x) {
  return x > -2147483649 && x < 2147483648 ? Math.trunc(x) + 0 : -2147483648;
}

// @helper to_int64
function to_int64(x) {
  return x >= -9223372036854775808 && x < 9223372036854775808 ? Math.trunc(x) + 0 : -9223372036854775808;
}

// @helper wide_int
function wide_int(x) {
  return BigInt.asUintN(64, BigInt(to_int64(x)));
}

// @helper wide_uint
function wide_uint(x) {
  return x >= 9223372036854775808 ? wide_int(x - 9223372036854775808) ^ 9223372036854775808n : wide_int(x);
}

// @helper wide
function wide(high, low) {
  return BigInt.asUintN(64, wide_int(high) << 32n) | (wide_int(low) & 0xffffffffn);
}

// @helper int_div
function int_div(x, y) {
  return Math.trunc(x / y) + 0;
}

// @helper int_neg
function int_neg(x) {
  return x === 0 ? 0 : -x;
}

// @helper mul_uint32
function mul_uint32(x, y) {
  return Math.imul(within64(x), within64(y)) >>> 0;
}

// @helper wide_div
function wide_div(x, y) {
  return y === 0n ? 0n : BigInt.asUintN(64, BigInt.asIntN(64, x) / BigInt.asIntN(64, y));
}

// @helper wide_rem
function wide_rem(x, y) {
  return y === 0n ? 0n : BigInt.asUintN(64, BigInt.asIntN(64, x) % BigInt.asIntN(64, y));
}

// @helper wide_udiv
function wide_udiv(x, y) {
  return y === 0n ? 0n : x / y;
}

// @helper wide_urem
function wide_urem(x, y) {
  return y === 0n ? 0n : x % y;
}

// @helper wide_and
function wide_and(x, y) {
  return x & y;
}

// @helper wide_or
function wide_or(x, y) {
  return x | y;
}

// @helper wide_xor
function wide_xor(x, y) {
  return x ^ y;
}

// @helper wide_shl
function wide_shl(x, n) {
  return BigInt.asUintN(64, x << (n & 63n));
}

// @helper wide_shr
function wide_shr(x, n) {
  return BigInt.asUintN(64, BigInt.asIntN(64, x) >> (n & 63n));
}

// @helper wide_ushr
function wide_ushr(x, n) {
  return x >> (n & 63n);
}

// @helper wide_less
function wide_less(x, y) {
  return BigInt.asIntN(64, x) < BigInt.asIntN(64, y);
}

// @helper report_value
let all_finite = true;
function report_value(value, what) {
  if (all_finite) console.error("not finite: " + what + " is " + value);
  all_finite = false;
}

// @text module.functions

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


// @text module.guards_begin

// The condition of a guard and its places in the source.
export function $guard_text(guard) {
  const text = [

// @text module.main
import * as kernel from "./$base.mjs";

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
