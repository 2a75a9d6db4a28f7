#include "engine/emit/languages/languages.h"
#include "engine/emit/print/module.h"

#include <algorithm>
#include <array>

namespace symreal {

static constexpr auto keywords = std::to_array<std::string_view>(
    {"Inf",    "NaN",    "break",    "case",        "catch",  "classdef",       "continue", "do",   "double",
     "else",   "elseif", "end",      "endfunction", "endif",  "endwhile",       "false",    "for",  "function",
     "global", "guard",  "if",       "otherwise",   "parfor", "persistent",     "return",   "spmd", "switch",
     "true",   "try",    "typecast", "uint64",      "until",  "unwind_protect", "while",    "zeros"});
static_assert(std::ranges::is_sorted(keywords));

// MATLAB functions with complex results have a helper that returns NaN instead; uint64 saturates, so its sums and
// products are built from halves.
static constexpr OperationSpelling spellings[] = {
    {Op::abs, "abs($x)"},
    {Op::sqrt, "real_sqrt($x)"},
    {Op::fmin, "min($x, $y)"},
    {Op::fmax, "max($x, $y)"},
    {Op::trunc, "fix($x)"},
    {Op::f32, "double(single($x))"},
    {Op::wrap_int8, "wrapped($x, 8)"},
    {Op::wrap_int16, "wrapped($x, 16)"},
    {Op::wrap_int32, "wrapped($x, 32)"},
    {Op::wrap_uint8, "low_bits($x, 8)"},
    {Op::wrap_uint16, "low_bits($x, 16)"},
    {Op::wrap_uint32, "low_bits($x, 32)"},
    {Op::wide_add, "wide_add($x, $y)"},
    {Op::wide_sub, "wide_sub($x, $y)"},
    {Op::wide_mul, "wide_mul($x, $y)"},
    {Op::wide_and, "bitand($x, $y)"},
    {Op::wide_or, "bitor($x, $y)"},
    {Op::wide_xor, "bitxor($x, $y)"},
    {Op::wide_select, "pick($x, $y, $z)"},
    {Op::wide_value, "double(typecast($x, 'int64'))"},
    {Op::wide_uvalue, "double($x)"},
    {Op::wide_low, "double(bitand($x, uint64(4294967295)))"},
    {Op::asin, "real_asin($x)"},
    {Op::acos, "real_acos($x)"},
    {Op::acosh, "real_acosh($x)"},
    {Op::atanh, "real_atanh($x)"},
    {Op::exp2, "real_pow(2.0, $x)"},
    {Op::log, "real_log($x)"},
    {Op::log2, "real_log2($x)"},
    {Op::log10, "real_log10($x)"},
    {Op::log1p, "real_log1p($x)"},
    {Op::pow, "real_pow($x, $y)"},
    {Op::ne, "$x:12 ~= $y:12", 9},
    {Op::logical_not, "~$x:15", 14},
    {Op::select, "pick($x, $y, $z)"},
};

static constexpr Helper helpers[] = {
    {"pick", R"(function z = pick(condition, x, y)
  if condition, z = x; else, z = y; end
end
)"},
    {"table_index", R"(% An index outside of its table reads the nearest element.
function k = table_index(index, extent)
  if index > 0, k = min(fix(index), extent - 1); else, k = 0; end
end
)"},
    {"real_sqrt", R"(function y = real_sqrt(x)
  if x < 0, y = NaN; else, y = sqrt(x); end
end
)"},
    {"real_asin", R"(function y = real_asin(x)
  if abs(x) > 1, y = NaN; else, y = asin(x); end
end
)"},
    {"real_acos", R"(function y = real_acos(x)
  if abs(x) > 1, y = NaN; else, y = acos(x); end
end
)"},
    {"real_acosh", R"(function y = real_acosh(x)
  if x < 1, y = NaN; else, y = acosh(x); end
end
)"},
    {"real_atanh", R"(function y = real_atanh(x)
  if abs(x) > 1, y = NaN; else, y = atanh(x); end
end
)"},
    {"real_log", R"(function y = real_log(x)
  if x < 0, y = NaN; else, y = log(x); end
end
)"},
    {"real_log2", R"(function y = real_log2(x)
  if x < 0, y = NaN; else, y = log2(x); end
end
)"},
    {"real_log10", R"(function y = real_log10(x)
  if x < 0, y = NaN; else, y = log10(x); end
end
)"},
    {"real_log1p", R"(function y = real_log1p(x)
  if x < -1, y = NaN; else, y = log1p(x); end
end
)"},
    {"real_pow", R"(function z = real_pow(x, y)
  if x == 1 || y == 0, z = 1; return; end
  if x < 0 && y ~= fix(y) && x ~= -Inf, z = NaN; return; end
  z = abs(x)^y;
  if typecast(x, 'int64') < 0 && mod(y, 2) == 1, z = -z; end
end
)"},
    {"cbrt", R"(function y = cbrt(x)
  [m, e] = log2(x);
  if x == 0 || ~(abs(x) < Inf)
    y = x;
  else
    e = e - 3*floor(e/3);
    y = nthroot(m*2^e, 3)*2^((exponent_of(x) - e)/3);
  end
end
)"},
    {"exponent_of", R"(function e = exponent_of(x)
  [~, e] = log2(x);
end
)"},
    {"fdim", R"(function z = fdim(x, y)
  if x <= y, z = 0; else, z = x - y; end
end
)"},
    {"fmod", R"(function r = fmod(x, y)
  r = abs(x);
  y = abs(y);
  if isnan(y) || ~(r < Inf) || y == 0, r = NaN; return; end
  if r >= y
    [~, highest] = log2(r);
    [~, lowest] = log2(y);
    for k = highest - lowest:-1:0
      multiple = scaled(y, k);
      if r >= multiple, r = r - multiple; end
    end
  end
  r = copysign(r, x);
end
)"},
    {"remainder", R"(function r = remainder(x, y)
  y = abs(y);
  if ~(y > 0) || ~(abs(x) < Inf), r = NaN; return; end
  if y == Inf, r = x; return; end
  r = fmod(abs(x), y);
  twice = r - (y - r);
  odd = y < 8.98846567431158e307 && fmod(abs(x), 2*y) >= y;
  if twice > 0 || (twice == 0 && odd), r = r - y; end
  if typecast(x, 'int64') < 0, r = -r; end
end
)"},
    {"scaled", R"(% x times a power of 2, in two steps since one may be beyond the range.
function y = scaled(x, exponent)
  half = fix(exponent/2);
  y = x*2^half*2^(exponent - half);
end
)"},
    {"rint", R"(function y = rint(x)
  y = x;
  if abs(x) < 4503599627370496, y = copysign(abs(x) + 4503599627370496 - 4503599627370496, x); end
end
)"},
    {"copysign", R"(function z = copysign(x, y)
  z = abs(x);
  if typecast(y, 'int64') < 0, z = -z; end
end
)"},
    {"nextafter", R"(function z = nextafter(x, y)
  if isnan(x) || isnan(y)
    z = NaN;
  elseif x == y
    z = y;
  elseif x == 0
    z = copysign(2^-1074, y);
  else
    step = int64(1);
    if (x < y) ~= (x > 0), step = int64(-1); end
    z = typecast(typecast(x, 'int64') + step, 'double');
  end
end
)"},
    {"logb", R"(function y = logb(x)
  [~, exponent] = log2(abs(x));
  y = exponent - 1;
  if x == 0, y = -Inf; end
  if ~(abs(x) < Inf), y = x*x; end
end
)"},
    {"two_sum", R"(% The sum, and what its rounding left out.
function [s, e] = two_sum(x, y)
  s = x + y;
  t = s - x;
  e = (x - (s - t)) + (y - t);
end
)"},
    {"odd_sum", R"(% The sum, rounded to the number with an odd last bit where it is none itself.
function s = odd_sum(x, y)
  [s, e] = two_sum(x, y);
  if e ~= 0 && mod(typecast(s, 'uint64'), 2) == 0
    step = int64(1);
    if (e > 0) ~= (s > 0), step = int64(-1); end
    s = typecast(typecast(s, 'int64') + step, 'double');
  end
end
)"},
    {"fma",
     R"(% Boldo and Melquiond, "Emulation of FMA and correctly rounded sums: proved algorithms using rounding to odd", IEEE
% Transactions on Computers 57 (2008), on mantissas; a result below the normal numbers is rounded at their last bit.
function r = fma(x, y, z)
  if ~(abs(x) < Inf && abs(y) < Inf) || x == 0 || y == 0, r = x*y + z; return; end
  if ~(abs(z) < Inf), r = z; return; end
  [x, ex] = log2(x);
  [y, ey] = log2(y);
  e = ex + ey;
  [z, ez] = log2(z);
  if z ~= 0 && ez - e > 60, r = scaled(z, ez); return; end
  z = scaled(z, max(ez - e, -160));
  p = x*y;
  t = 134217729*x; xh = t - (t - x); xl = x - xh;
  t = 134217729*y; yh = t - (t - y); yl = y - yh;
  q = xl*yl - (((p - xh*yh) - xl*yh) - xh*yl);
  [th, tl] = two_sum(z, q);
  [vh, vl] = two_sum(p, th);
  w = odd_sum(tl, vl);
  r = vh + w;
  if r ~= 0 && exponent_of(r) + e < -1021
    unit = scaled(copysign(4503599627370496, r), -1074 - e);
    [g, h] = two_sum(unit, vh);
    r = (g + odd_sum(h, w)) - unit;
    if r == 0, r = copysign(0, vh); end
  end
  r = scaled(r, e);
end
)"},
    {"tgamma", R"(function y = tgamma(x)
  if x < 0 && x == fix(x), y = NaN; else, y = gamma(x); end
end
)"},
    {"lgamma", R"(function y = lgamma(x)
  if x >= 0 || isnan(x)
    y = gammaln(x);
  elseif x == fix(x)
    y = Inf;
  else
    y = log(pi/abs(sin(pi*(x - 2*round(x/2))))) - gammaln(1 - x);
  end
end
)"},
    {"to_int32", R"(function y = to_int32(x)
  if x > -2147483649 && x < 2147483648, y = fix(x) + 0; else, y = -2147483648; end
end
)"},
    {"to_int64", R"(function y = to_int64(x)
  if x >= -9223372036854775808 && x < 9223372036854775808, y = fix(x) + 0; else, y = -9223372036854775808; end
end
)"},
    {"wide_int", R"(function y = wide_int(x)
  y = typecast(int64(to_int64(x)), 'uint64');
end
)"},
    {"wide_uint", R"(function y = wide_uint(x)
  if x >= 9223372036854775808
    y = bitxor(wide_int(x - 9223372036854775808), 0x8000000000000000u64);
  else
    y = wide_int(x);
  end
end
)"},
    {"low_half", R"(function y = low_half(x)
  y = bitand(x, uint64(4294967295));
end
)"},
    {"wide", R"(function z = wide(high, low)
  z = bitor(bitshift(low_half(wide_int(high)), 32), low_half(wide_int(low)));
end
)"},
    {"wide_add", R"(function z = wide_add(x, y)
  low = low_half(x) + low_half(y);
  high = bitshift(x, -32) + bitshift(y, -32) + bitshift(low, -32);
  z = bitor(bitshift(low_half(high), 32), low_half(low));
end
)"},
    {"wide_sub", R"(function z = wide_sub(x, y)
  z = wide_add(x, wide_neg(y));
end
)"},
    {"wide_neg", R"(function y = wide_neg(x)
  y = wide_add(bitxor(x, 0xFFFFFFFFFFFFFFFFu64), uint64(1));
end
)"},
    {"wide_mul", R"(function z = wide_mul(x, y)
  low = low_half(x)*low_half(y);
  middle = low_half(low_half(x)*bitshift(y, -32)) + low_half(bitshift(x, -32)*low_half(y));
  z = wide_add(low, bitshift(low_half(middle), 32));
end
)"},
    {"low_bits", R"(function y = low_bits(x, width)
  y = double(bitand(wide_int(x), uint64(2^width - 1)));
end
)"},
    {"wrapped", R"(function y = wrapped(x, width)
  y = low_bits(x, width);
  if y >= 2^(width - 1), y = y - 2^width; end
end
)"},
    {"int_div", R"(function z = int_div(x, y)
  z = fix(x/y) + 0;
end
)"},
    {"int_neg", R"(function y = int_neg(x)
  if x == 0, y = 0; else, y = -x; end
end
)"},
    {"mul_uint32", R"(function z = mul_uint32(x, y)
  z = double(low_half(wide_mul(wide_int(x), wide_int(y))));
end
)"},
    {"wide_size", R"(function y = wide_size(x)
  if bitshift(x, -63) == 1, y = wide_neg(x); else, y = x; end
end
)"},
    {"wide_div", R"(function z = wide_div(x, y)
  z = wide_udiv(wide_size(x), wide_size(y));
  if bitshift(bitxor(x, y), -63) == 1, z = wide_neg(z); end
end
)"},
    {"wide_rem", R"(function z = wide_rem(x, y)
  z = wide_urem(wide_size(x), wide_size(y));
  if bitshift(x, -63) == 1, z = wide_neg(z); end
end
)"},
    {"wide_udiv", R"(function z = wide_udiv(x, y)
  if y == 0, z = uint64(0); else, z = (x - mod(x, y))/y; end
end
)"},
    {"wide_urem", R"(function z = wide_urem(x, y)
  if y == 0, z = uint64(0); else, z = mod(x, y); end
end
)"},
    {"wide_shl", R"(function z = wide_shl(x, n)
  z = bitshift(x, double(bitand(n, uint64(63))));
end
)"},
    {"wide_shr", R"(function z = wide_shr(x, n)
  z = wide_ushr(x, n);
  if bitshift(x, -63) == 1
    ones = 0xFFFFFFFFFFFFFFFFu64;
    z = bitor(z, bitxor(ones, wide_ushr(ones, n)));
  end
end
)"},
    {"wide_ushr", R"(function z = wide_ushr(x, n)
  z = bitshift(x, -double(bitand(n, uint64(63))));
end
)"},
    {"wide_less", R"(function z = wide_less(x, y)
  z = typecast(x, 'int64') < typecast(y, 'int64');
end
)"},
};

static constexpr Companion beside[] = {{"_main.m", module_main, "mainline"}};

Language language_matlab() {
  Language matlab;
  matlab.names = {keywords, false};
  matlab.comment = {"% ", "% ", ""};
  matlab.lines = {.width = 100, .least = 60, .continuation = " ..."};
  matlab.numbers = {"NaN", "NaN", "Inf", "-Inf"};
  matlab.number = {"", "0.0"};
  matlab.truth = {"", "false"};
  matlab.wide = {"", "uint64(0)"};
  matlab.expressions = {
      .operations = spellings,
      .element = "$array($index)",
      .first_index = 1,
      .yes = "true",
      .truth_as_number = "double($x)",
      .small_integer = "uint64($value)",
      .large_integer = "0x${hex}u64",
      .kept_integer = "typecast($element, 'uint64')",
      .table_index = "table_index($index, $extent)",
  };
  matlab.statements = {
      .variable = "$name = $value;",
      .constant = "$name = $value;",
      .set = "$name = $value;",
      .keep_integer = "$element = typecast($value, 'double');",
      .array = "$name = zeros($count, 1);",
      .zero_array = "$name = zeros($count, 1);",
      .open = "if $condition",
      .otherwise = "else",
      .close = "end",
      .check = "if $condition, guard = $number; output = []; return; end",
  };
  matlab.functions = {
      .head = "function [$target, guard] = ${name}_steps($parameters)",
      .local_head = "function [$target, guard] = $name($parameters)",
      .end = "end",
      .input = "$name",
      .local_output = "$name",
      .results = "$name = zeros($count, 1);",
      .finish = "guard = 0;",
      .local_finish = "guard = 0;",
      .call = "v = $name($arguments);",
      .checked_call = "[v, guard] = $name($arguments);\nif guard ~= 0, output = []; return; end",
  };
  matlab.tables = {
      .begin = "function value = $name(index)\n  persistent values\n  if isempty(values)\n    values = [",
      .end = "];\n  end\n  value = values(index);\nend",
  };
  matlab.files = {
      .extension = ".m",
      .kept_when = ", as far as the functions\nof MATLAB or Octave are those of the C library",
      .begin = module_begin,
      .helpers = helpers,
      .end = module_end,
      .companions = beside,
  };
  matlab.strings = {.quote = "'", .doubles_quotes = true};
  matlab.module = {
      .is_named_after_file = true,
      .begin = R"(%
% kernel = $base() gives the functions and the sizes. MATLAB R2019b, or Octave 7.
%
% constants = kernel.$preprocess(parameters)
%   For $parameters parameters. Once, and again whenever a parameter changes.
% output = kernel.$compute(input, constants)
%   The $outputs outputs for $inputs inputs. A guard that does not hold is an error;
%   [output, guard] = kernel.$compute(input, constants) gives its number instead, 0 where all hold.
% input = kernel.pack(objects, kernel.input_at)
%   The numbers of the fields of a struct, which have the shapes of the source.
% objects = kernel.unpack(output, kernel.output_at)
%   Back again.
function kernel = $base()
  kernel.$preprocess = @$preprocess;
  kernel.$compute = @$compute;
  kernel.$guard_text = @$guard_text;
  kernel.pack = @pack;
  kernel.unpack = @unpack;
)",
      .size = "  kernel.$name = $value;\n",
      .index_list = "  kernel.$name = [$values];\n",
      .places = {.object = "  kernel.${role}_at.$name = struct('first', $first, 'extents', [$extents]);\n"},
      .functions = R"(end

function constants = $preprocess(parameters)
  if nargin < 1, parameters = []; end
  constants = ${preprocess}_steps(sized(parameters, $parameters, 'parameters'));
end

function [output, guard] = $compute(input, constants)
  if nargin < 2, constants = $preprocess(); end
  input = sized(input, $inputs, 'input');
  [output, guard] = ${compute}_steps(input, sized(constants, $constants, 'constants'));
  if guard ~= 0 && nargout < 2
    error('$module:guard', 'guard %d does not hold: %s', guard, $guard_text(guard));
  end
end

function numbers = sized(numbers, count, name)
  if numel(numbers) ~= count
    error('$module:size', '%s has %d numbers, not %d', name, numel(numbers), count);
  end
end

function numbers = pack(objects, at)
  numbers = zeros(0, 1);
  for name = fieldnames(at)'
    extents = at.(name{1}).extents;
    value = objects.(name{1});
    if numel(extents) > 1
      if ~isequal(size(value), extents)
        error('$module:size', '%s is %s, not %s', name{1}, mat2str(size(value)), mat2str(extents));
      end
      value = permute(value, numel(extents):-1:1);
    end
    numbers = [numbers; sized(value(:), prod(extents), name{1})];
  end
end

function objects = unpack(numbers, at)
  for name = fieldnames(at)'
    first = at.(name{1}).first;
    extents = at.(name{1}).extents;
    value = reshape(numbers(first:first + prod(extents) - 1), [], 1);
    if numel(extents) > 1
      value = permute(reshape(value, fliplr(extents)), numel(extents):-1:1);
    end
    objects.(name{1}) = value;
  end
end

)",
      .guards_begin = "\n% The condition of a guard and its places in the source.\nfunction text = $guard_text(guard)\n"
                      "  texts = { ...\n",
      .guard = "    $text, ...\n",
      .guards_end = "    };\n  text = texts{guard};\nend\n",
      .no_guards = "\nfunction text = $guard_text(guard)\n  text = '';\nend\n",
      .main =
          R"(% Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
kernel = $base();
values = [$all_values];
names = {$labels};
given = {};
if exist('OCTAVE_VERSION', 'builtin'), given = argv(); end
for i = 1:min(numel(given), numel(values)), values(i) = str2double(given{i}); end
constants = kernel.$preprocess(values($inputs + 1:end));
$call
for i = 1:numel(names), fprintf('%s = %.17g\n', names{i}, output(i)); end
)",
      .call = "output = kernel.$compute(values(1:$inputs), constants);",
      .checked_call = R"([output, guard] = kernel.$compute(values(1:$inputs), constants);
if guard ~= 0
  fprintf(2, 'guard %d does not hold: %s\n', guard, kernel.$guard_text(guard));
  exit(1);
end)",
  };
  return matlab;
}

} // namespace symreal
