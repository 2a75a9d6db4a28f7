% Helpers of MATLAB, and the code around functions, for matlab.toml. Marks: language_file.h.

% @helper pick
function z = pick(condition, x, y)
  if condition, z = x; else, z = y; end
end

% @helper table_index
% An index outside of its table reads the nearest element.
function k = table_index(index, extent)
  if index > 0, k = min(fix(index), extent - 1); else, k = 0; end
end

% @helper real_sqrt
function y = real_sqrt(x)
  if x < 0, y = NaN; else, y = sqrt(x); end
end

% @helper real_asin
function y = real_asin(x)
  if abs(x) > 1, y = NaN; else, y = asin(x); end
end

% @helper real_acos
function y = real_acos(x)
  if abs(x) > 1, y = NaN; else, y = acos(x); end
end

% @helper real_acosh
function y = real_acosh(x)
  if x < 1, y = NaN; else, y = acosh(x); end
end

% @helper real_atanh
function y = real_atanh(x)
  if abs(x) > 1, y = NaN; else, y = atanh(x); end
end

% @helper real_log
function y = real_log(x)
  if x < 0, y = NaN; else, y = log(x); end
end

% @helper real_log2
function y = real_log2(x)
  if x < 0, y = NaN; else, y = log2(x); end
end

% @helper real_log10
function y = real_log10(x)
  if x < 0, y = NaN; else, y = log10(x); end
end

% @helper real_log1p
function y = real_log1p(x)
  if x < -1, y = NaN; else, y = log1p(x); end
end

% @helper real_pow
function z = real_pow(x, y)
  if x == 1 || y == 0, z = 1; return; end
  if x < 0 && y ~= fix(y) && x ~= -Inf, z = NaN; return; end
  z = abs(x)^y;
  if typecast(x, 'int64') < 0 && mod(y, 2) == 1, z = -z; end
end

% @helper cbrt
function y = cbrt(x)
  [m, e] = log2(x);
  if x == 0 || ~(abs(x) < Inf)
    y = x;
  else
    e = e - 3*floor(e/3);
    y = nthroot(m*2^e, 3)*2^((exponent_of(x) - e)/3);
  end
end

% @helper exponent_of
function e = exponent_of(x)
  [~, e] = log2(x);
end

% @helper fdim
function z = fdim(x, y)
  if x <= y, z = 0; else, z = x - y; end
end

% @helper fmod
function r = fmod(x, y)
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

% @helper remainder
function r = remainder(x, y)
  y = abs(y);
  if ~(y > 0) || ~(abs(x) < Inf), r = NaN; return; end
  if y == Inf, r = x; return; end
  r = fmod(abs(x), y);
  twice = r - (y - r);
  odd = y < 8.98846567431158e307 && fmod(abs(x), 2*y) >= y;
  if twice > 0 || (twice == 0 && odd), r = r - y; end
  if typecast(x, 'int64') < 0, r = -r; end
end

% @helper scaled
% x times a power of 2, in two steps since one may be beyond the range.
function y = scaled(x, exponent)
  half = fix(exponent/2);
  y = x*2^half*2^(exponent - half);
end

% @helper rint
function y = rint(x)
  y = x;
  if abs(x) < 4503599627370496, y = copysign(abs(x) + 4503599627370496 - 4503599627370496, x); end
end

% @helper copysign
function z = copysign(x, y)
  z = abs(x);
  if typecast(y, 'int64') < 0, z = -z; end
end

% @helper nextafter
function z = nextafter(x, y)
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

% @helper logb
function y = logb(x)
  [~, exponent] = log2(abs(x));
  y = exponent - 1;
  if x == 0, y = -Inf; end
  if ~(abs(x) < Inf), y = x*x; end
end

% @helper two_sum
% The sum, and what its rounding left out.
function [s, e] = two_sum(x, y)
  s = x + y;
  t = s - x;
  e = (x - (s - t)) + (y - t);
end

% @helper odd_sum
% The sum, rounded to the number with an odd last bit where it is none itself.
function s = odd_sum(x, y)
  [s, e] = two_sum(x, y);
  if e ~= 0 && mod(typecast(s, 'uint64'), 2) == 0
    step = int64(1);
    if (e > 0) ~= (s > 0), step = int64(-1); end
    s = typecast(typecast(s, 'int64') + step, 'double');
  end
end

% @helper fma
% Boldo and Melquiond, "Emulation of FMA and correctly rounded sums: proved algorithms using rounding to odd", IEEE
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

% @helper tgamma
function y = tgamma(x)
  if x < 0 && x == fix(x), y = NaN; else, y = gamma(x); end
end

% @helper lgamma
function y = lgamma(x)
  if x >= 0 || isnan(x)
    y = gammaln(x);
  elseif x == fix(x)
    y = Inf;
  else
    y = log(pi/abs(sin(pi*(x - 2*round(x/2))))) - gammaln(1 - x);
  end
end

% @helper to_int32
function y = to_int32(x)
  if x > -2147483649 && x < 2147483648, y = fix(x) + 0; else, y = -2147483648; end
end

% @helper to_int64
function y = to_int64(x)
  if x >= -9223372036854775808 && x < 9223372036854775808, y = fix(x) + 0; else, y = -9223372036854775808; end
end

% @helper wide_int
function y = wide_int(x)
  y = typecast(int64(to_int64(x)), 'uint64');
end

% @helper wide_uint
function y = wide_uint(x)
  if x >= 9223372036854775808
    y = bitxor(wide_int(x - 9223372036854775808), 0x8000000000000000u64);
  else
    y = wide_int(x);
  end
end

% @helper low_half
function y = low_half(x)
  y = bitand(x, uint64(4294967295));
end

% @helper wide
function z = wide(high, low)
  z = bitor(bitshift(low_half(wide_int(high)), 32), low_half(wide_int(low)));
end

% @helper wide_add
function z = wide_add(x, y)
  low = low_half(x) + low_half(y);
  high = bitshift(x, -32) + bitshift(y, -32) + bitshift(low, -32);
  z = bitor(bitshift(low_half(high), 32), low_half(low));
end

% @helper wide_sub
function z = wide_sub(x, y)
  z = wide_add(x, wide_neg(y));
end

% @helper wide_neg
function y = wide_neg(x)
  y = wide_add(bitxor(x, 0xFFFFFFFFFFFFFFFFu64), uint64(1));
end

% @helper wide_mul
function z = wide_mul(x, y)
  low = low_half(x)*low_half(y);
  middle = low_half(low_half(x)*bitshift(y, -32)) + low_half(bitshift(x, -32)*low_half(y));
  z = wide_add(low, bitshift(low_half(middle), 32));
end

% @helper low_bits
function y = low_bits(x, width)
  y = double(bitand(wide_int(x), uint64(2^width - 1)));
end

% @helper wrapped
function y = wrapped(x, width)
  y = low_bits(x, width);
  if y >= 2^(width - 1), y = y - 2^width; end
end

% @helper int_div
function z = int_div(x, y)
  z = fix(x/y) + 0;
end

% @helper int_neg
function y = int_neg(x)
  if x == 0, y = 0; else, y = -x; end
end

% @helper mul_uint32
function z = mul_uint32(x, y)
  z = double(low_half(wide_mul(wide_int(x), wide_int(y))));
end

% @helper wide_size
function y = wide_size(x)
  if bitshift(x, -63) == 1, y = wide_neg(x); else, y = x; end
end

% @helper wide_div
function z = wide_div(x, y)
  z = wide_udiv(wide_size(x), wide_size(y));
  if bitshift(bitxor(x, y), -63) == 1, z = wide_neg(z); end
end

% @helper wide_rem
function z = wide_rem(x, y)
  z = wide_urem(wide_size(x), wide_size(y));
  if bitshift(x, -63) == 1, z = wide_neg(z); end
end

% @helper wide_udiv
function z = wide_udiv(x, y)
  if y == 0, z = uint64(0); else, z = (x - mod(x, y))/y; end
end

% @helper wide_urem
function z = wide_urem(x, y)
  if y == 0, z = uint64(0); else, z = mod(x, y); end
end

% @helper wide_shl
function z = wide_shl(x, n)
  z = bitshift(x, double(bitand(n, uint64(63))));
end

% @helper wide_shr
function z = wide_shr(x, n)
  z = wide_ushr(x, n);
  if bitshift(x, -63) == 1
    ones = 0xFFFFFFFFFFFFFFFFu64;
    z = bitor(z, bitxor(ones, wide_ushr(ones, n)));
  end
end

% @helper wide_ushr
function z = wide_ushr(x, n)
  z = bitshift(x, -double(bitand(n, uint64(63))));
end

% @helper wide_less
function z = wide_less(x, y)
  z = typecast(x, 'int64') < typecast(y, 'int64');
end

% @text module.begin
%
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

% @text module.functions
end

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


% @text module.guards_begin

% The condition of a guard and its places in the source.
function text = $guard_text(guard)
  texts = { ...

% @text module.no_guards

function text = $guard_text(guard)
  text = '';
end

% @text module.main
% Runs the kernel once and prints its outputs. Arguments replace the recorded inputs in order, then the parameters.
kernel = $base();
values = [$all_values];
names = {$labels};
given = {};
if exist('OCTAVE_VERSION', 'builtin'), given = argv(); end
for i = 1:min(numel(given), numel(values)), values(i) = str2double(given{i}); end
constants = kernel.$preprocess(values($inputs + 1:end));
$call
for i = 1:numel(names), fprintf('%s = %.17g\n', names{i}, output(i)); end
