"""Integer arithmetic as gcc does it, on intervals: the type of each result, and what values it may have."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Integer:
    bits: int
    signed: bool
    truth: bool = False

    @property
    def low(self):
        return -(1 << (self.bits - 1)) if self.signed else 0

    @property
    def high(self):
        return 1 if self.truth else (1 << (self.bits - self.signed)) - 1

    def holds(self, low, high):
        return self.low <= low and high <= self.high


INT = Integer(32, True)
UNSIGNED = Integer(32, False)
LONG = Integer(64, True)
SIZE = Integer(64, False)
BOOL = Integer(8, False, truth=True)
DOUBLE = "double"
FLOAT = "float"

SPELLINGS = {
    Integer(8, True): ["signed char", "int8_t"],
    Integer(8, False): ["unsigned char", "uint8_t"],
    Integer(16, True): ["short", "int16_t"],
    Integer(16, False): ["unsigned short", "uint16_t"],
    INT: ["int", "int", "int32_t"],
    UNSIGNED: ["unsigned", "unsigned int", "uint32_t"],
    LONG: ["long", "long long", "int64_t"],
    SIZE: ["unsigned long", "size_t", "uint64_t", "unsigned long long"],
}


def promoted(type):
    return INT if type.bits < 32 else type


def common(a, b):
    """The type of an operation on two operands (C11 6.3.1.8, with gcc's wide bit-fields as types of their own)."""
    a, b = promoted(a), promoted(b)
    if a.signed == b.signed:
        return a if a.bits >= b.bits else b
    unsigned, signed = (b, a) if a.signed else (a, b)
    return unsigned if unsigned.bits >= signed.bits else signed


def within(type, low, high):
    """The interval as a value of `type`, None where a signed result would overflow."""
    if type.holds(low, high):
        return low, high
    return None if type.signed else (type.low, type.high)


def converted(type, low, high):
    """Conversion of an integer: gcc wraps for signed types as well."""
    if type.truth:
        return (0, 0) if low == high == 0 else (0, 1)
    return (low, high) if type.holds(low, high) else (type.low, type.high)


def corners(operation, a, b):
    values = [operation(p, q) for p in a for q in b]
    return min(values), max(values)


def below_power(value):
    return (1 << value.bit_length()) - 1


def binary(operator, type, a, b):
    """The interval of `a operator b`, both converted to `type` already; None where it is undefined somewhere."""
    if operator == "+":
        return within(type, a[0] + b[0], a[1] + b[1])
    if operator == "-":
        return within(type, a[0] - b[1], a[1] - b[0])
    if operator == "*":
        return within(type, *corners(lambda p, q: p * q, a, b))
    if operator in "/%":
        if b[0] <= 0 <= b[1] or (type.signed and a[0] == type.low and b[0] < 0):
            return None
        if operator == "/":
            return corners(lambda p, q: abs(p) // abs(q) * (1 if (p < 0) == (q < 0) else -1), a, b)
        bound = max(abs(b[0]), abs(b[1])) - 1
        return (max(a[0], -bound) if a[0] < 0 else 0), (min(a[1], bound) if a[1] > 0 else 0)
    if operator == "&":
        if a[0] >= 0 and b[0] >= 0:
            return 0, min(a[1], b[1])
        if a[0] >= 0 or b[0] >= 0:
            return 0, a[1] if a[0] >= 0 else b[1]
        return type.low, type.high
    if operator in "|^":
        return (0, below_power(max(a[1], b[1]))) if a[0] >= 0 and b[0] >= 0 else (type.low, type.high)
    raise ValueError(operator)


def shifted(operator, type, a, amount):
    if operator == ">>":
        return a[0] >> amount, a[1] >> amount
    if type.signed and (a[0] < 0 or a[1] << amount > type.high):
        return None
    return within(type, a[0] << amount, a[1] << amount)
