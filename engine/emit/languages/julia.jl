# Helpers of Julia, and the code around functions, for julia.toml. Marks: language_file.h.

# @declarations
c_sqrt(x) = ccall((:sqrt, libm), Float64, (Float64,), x)
c_cbrt(x) = ccall((:cbrt, libm), Float64, (Float64,), x)
c_hypot(x, y) = ccall((:hypot, libm), Float64, (Float64, Float64), x, y)
c_fma(x, y, z) = ccall((:fma, libm), Float64, (Float64, Float64, Float64), x, y, z)
c_fmin(x, y) = ccall((:fmin, libm), Float64, (Float64, Float64), x, y)
c_fmax(x, y) = ccall((:fmax, libm), Float64, (Float64, Float64), x, y)
c_fdim(x, y) = ccall((:fdim, libm), Float64, (Float64, Float64), x, y)
c_fmod(x, y) = ccall((:fmod, libm), Float64, (Float64, Float64), x, y)
c_remainder(x, y) = ccall((:remainder, libm), Float64, (Float64, Float64), x, y)
c_nextafter(x, y) = ccall((:nextafter, libm), Float64, (Float64, Float64), x, y)
c_logb(x) = ccall((:logb, libm), Float64, (Float64,), x)
c_sin(x) = ccall((:sin, libm), Float64, (Float64,), x)
c_cos(x) = ccall((:cos, libm), Float64, (Float64,), x)
c_tan(x) = ccall((:tan, libm), Float64, (Float64,), x)
c_asin(x) = ccall((:asin, libm), Float64, (Float64,), x)
c_acos(x) = ccall((:acos, libm), Float64, (Float64,), x)
c_atan(x) = ccall((:atan, libm), Float64, (Float64,), x)
c_atan2(x, y) = ccall((:atan2, libm), Float64, (Float64, Float64), x, y)
c_sinh(x) = ccall((:sinh, libm), Float64, (Float64,), x)
c_cosh(x) = ccall((:cosh, libm), Float64, (Float64,), x)
c_tanh(x) = ccall((:tanh, libm), Float64, (Float64,), x)
c_asinh(x) = ccall((:asinh, libm), Float64, (Float64,), x)
c_acosh(x) = ccall((:acosh, libm), Float64, (Float64,), x)
c_atanh(x) = ccall((:atanh, libm), Float64, (Float64,), x)
c_exp(x) = ccall((:exp, libm), Float64, (Float64,), x)
c_exp2(x) = ccall((:exp2, libm), Float64, (Float64,), x)
c_expm1(x) = ccall((:expm1, libm), Float64, (Float64,), x)
c_log(x) = ccall((:log, libm), Float64, (Float64,), x)
c_log2(x) = ccall((:log2, libm), Float64, (Float64,), x)
c_log10(x) = ccall((:log10, libm), Float64, (Float64,), x)
c_log1p(x) = ccall((:log1p, libm), Float64, (Float64,), x)
c_pow(x, y) = ccall((:pow, libm), Float64, (Float64, Float64), x, y)
c_erf(x) = ccall((:erf, libm), Float64, (Float64,), x)
c_erfc(x) = ccall((:erfc, libm), Float64, (Float64,), x)
c_tgamma(x) = ccall((:tgamma, libm), Float64, (Float64,), x)
c_lgamma(x) = ccall((:lgamma, libm), Float64, (Float64,), x)

# @helper table_index
# An index outside of its table reads the nearest element.
table_index(index, extent) = !(index > 0) ? 0 : index < extent ? unsafe_trunc(Int, index) : extent - 1

# @helper wide_int
wide_int(x) = -9.223372036854775808e18 <= x < 9.223372036854775808e18 ?
    unsigned(unsafe_trunc(Int64, x)) : 0x8000000000000000

# @helper wide_uint
wide_uint(x) = x >= 9.223372036854775808e18 ?
    wide_int(x - 9.223372036854775808e18) ⊻ 0x8000000000000000 : wide_int(x)

# @helpers
wide(high, low) = wide_int(high) << 32 | wide_int(low) & 0x00000000ffffffff
to_int32(x) = -2147483649.0 < x < 2147483648.0 ? trunc(x) + 0.0 : -2147483648.0
to_int64(x) = Float64(signed(wide_int(x)))
int_div(x, y) = trunc(x/y) + 0.0
int_neg(x) = x == 0 ? 0.0 : -x
mul_uint32(x, y) = Float64((wide_int(x)*wide_int(y)) % UInt32)

# @helper wide_div
function wide_div(x, y)
    y == 0 && return UInt64(0)
    return signed(y) == -1 ? -x : unsigned(div(signed(x), signed(y)))
end

# @helpers
wide_rem(x, y) = y == 0 || signed(y) == -1 ? UInt64(0) : unsigned(rem(signed(x), signed(y)))
wide_udiv(x, y) = y == 0 ? UInt64(0) : div(x, y)
wide_urem(x, y) = y == 0 ? UInt64(0) : rem(x, y)
wide_and(x, y) = x & y
wide_or(x, y) = x | y
wide_xor(x, y) = x ⊻ y
wide_shl(x, n) = x << (n & 63)
wide_shr(x, n) = unsigned(signed(x) >> (n & 63))
wide_ushr(x, n) = x >> (n & 63)
wide_less(x, y) = signed(x) < signed(y)

# @text externals.bridge.begin
# Functions of the program's libraries, with structs as what they consist of, in the library that use_library names.
const library = Ref{Ptr{Cvoid}}(C_NULL)
use_library(path) = library[] = Base.Libc.Libdl.dlopen(path)
library_function(name) = library[] != C_NULL ? Base.Libc.Libdl.dlsym(library[], name) :
    error("the library that has $$name is not known: call use_library")


# @text module.begin

module $Module

# Where the mathematical library of C is.
const libm = Sys.iswindows() ? "ucrtbase" : Sys.isapple() ? "libSystem" : "libm.so.6"


# @text module.functions

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


# @text module.guards_begin

# The condition of a guard and its places in the source.
function $guard_text(guard)
    text = [

# @text module.main

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
