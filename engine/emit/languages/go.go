// Helpers of Go, and the code around functions, for go.toml. Marks: language_file.h.

// @helper nextafter
// Of zeros the second, as in C.
func nextafter(x, y float64) float64 {
    if x == y {
        return y
    }
    return math.Nextafter(x, y)
}

// @helper table_index
// An index outside of its table reads the nearest element.
func table_index(index float64, extent int) int {
    if !(index > 0) {
        return 0
    }
    if index < float64(extent) {
        return int(index)
    }
    return extent - 1
}

// @helper number
func number(c bool) float64 {
    if c {
        return 1
    }
    return 0
}

// @helper pick
func pick(c bool, y, z float64) float64 {
    if c {
        return y
    }
    return z
}

// @helper pick_integer
func pick_integer(c bool, y, z uint64) uint64 {
    if c {
        return y
    }
    return z
}

// @helper signed
func signed(x uint64) int64 {
    return int64(x)
}

// @helper fmin
func fmin(x, y float64) float64 {
    if x != x || y < x {
        return y
    }
    return x
}

// @helper fmax
func fmax(x, y float64) float64 {
    if x != x || y > x {
        return y
    }
    return x
}

// @helper fdim
func fdim(x, y float64) float64 {
    if x <= y {
        return 0
    }
    return x - y
}

// @helper log
// The logarithm of Go's package is wrong below the normal numbers.
func log(x float64) float64 {
    if x > 0 && x < 0x1p-1022 {
        return math.Log(x*0x1p54) - 37.42994775023705
    }
    return math.Log(x)
}

// @helper log2
// Near 1 the logarithm of Go's package subtracts numbers of nearly equal size.
func log2(x float64) float64 {
    if x > 0.75 && x < 1.5 {
        return math.Log(x) * math.Log2E
    }
    return math.Log2(x)
}

// @helper asin
// Near 1 and -1 the function of Go's package subtracts numbers of nearly equal size.
func asin(x float64) float64 {
    if math.Abs(x) > 0.5 {
        return math.Copysign(math.Pi/2-2*math.Asin(math.Sqrt((1-math.Abs(x))/2)), x)
    }
    return math.Asin(x)
}

// @helper acos
// Near 1 the function of Go's package subtracts numbers of nearly equal size.
func acos(x float64) float64 {
    if x > 0.5 {
        return 2 * math.Asin(math.Sqrt((1-x)/2))
    }
    return math.Acos(x)
}

// @helper pow
// The power of Go's package is wrong where the base is below the normal numbers.
func pow(x, y float64) float64 {
    if x != 0 && math.Abs(x) < 0x1p-1022 && !math.IsInf(y, 0) {
        return math.Pow(x*0x1p54, y) * math.Exp2(-54*y)
    }
    return math.Pow(x, y)
}

// @helper log10
func log10(x float64) float64 {
    if x > 0 && x < 0x1p-1022 {
        return math.Log10(x*0x1p54) - 16.255619765854984
    }
    return math.Log10(x)
}

// @helper lgamma
func lgamma(x float64) float64 {
    if math.Abs(x) < 1e-200 {
        return -log(math.Abs(x))
    }
    value, _ := math.Lgamma(x)
    if math.IsInf(x, -1) {
        return -x
    }
    return value
}

// @helper to_int32
func to_int32(x float64) float64 {
    if x > -2147483649 && x < 2147483648 {
        return float64(int32(x))
    }
    return -2147483648
}

// @helper to_int64
func to_int64(x float64) float64 {
    return float64(signed(wide_int(x)))
}

// @helper wide_int
func wide_int(x float64) uint64 {
    if x >= -0x1p63 && x < 0x1p63 {
        return uint64(int64(x))
    }
    return 1 << 63
}

// @helper wide_uint
func wide_uint(x float64) uint64 {
    if x >= 0x1p63 {
        return wide_int(x-0x1p63) ^ (1 << 63)
    }
    return wide_int(x)
}

// @helper wide
func wide(high, low float64) uint64 {
    return wide_int(high)<<32 | wide_int(low)&0xFFFFFFFF
}

// @helper int_div
func int_div(x, y float64) float64 {
    return math.Trunc(x/y) + 0
}

// @helper int_neg
func int_neg(x float64) float64 {
    if x == 0 {
        return 0
    }
    return -x
}

// @helper mul_uint32
func mul_uint32(x, y float64) float64 {
    return float64(uint32(wide_int(x)) * uint32(wide_int(y)))
}

// @helper wide_div
func wide_div(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return uint64(int64(x) / int64(y))
}

// @helper wide_rem
func wide_rem(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return uint64(int64(x) % int64(y))
}

// @helper wide_udiv
func wide_udiv(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return x / y
}

// @helper wide_urem
func wide_urem(x, y uint64) uint64 {
    if y == 0 {
        return 0
    }
    return x % y
}

// @helper wide_and
func wide_and(x, y uint64) uint64 {
    return x & y
}

// @helper wide_or
func wide_or(x, y uint64) uint64 {
    return x | y
}

// @helper wide_xor
func wide_xor(x, y uint64) uint64 {
    return x ^ y
}

// @helper wide_shl
func wide_shl(x, n uint64) uint64 {
    return x << (n & 63)
}

// @helper wide_shr
func wide_shr(x, n uint64) uint64 {
    return uint64(int64(x) >> (n & 63))
}

// @helper wide_ushr
func wide_ushr(x, n uint64) uint64 {
    return x >> (n & 63)
}

// @helper wide_less
func wide_less(x, y uint64) bool {
    return int64(x) < int64(y)
}

// @text module.begin

package $package

import (
    "math"
    "unsafe"
)

var _ = math.Pi


// @text module.structure.end
}

// Numbers gives the array that this is.
func (x *$Role) Numbers() []float64 {
    return unsafe.Slice((*float64)(unsafe.Pointer(x)), $count)
}

// @text module.guards_begin

// $GuardText gives the condition of a guard and its places in the source.
func $GuardText(guard int) string {
    text := [...]string{

// @text module.guards_end
    }
    if guard > 0 && guard <= len(text) {
        return text[guard-1]
    }
    return ""
}

// @text module.main

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
