// Patterns shared by generated Python modules and Python packages (syntax: language/language.h).
#pragma once

#include <string_view>

namespace symreal {

// The parts of Input, Output and compute for arrays.
inline constexpr std::string_view python_arrays = R"(

def _is_masked(values):
    if isinstance(values, (list, tuple)):
        return any(map(_is_masked, values))
    return isinstance(values, numpy.ma.MaskedArray) and numpy.ma.is_masked(values)


def _exact(values, name):
    """The array of the values as doubles; TypeError where one of them is none."""
    if _is_masked(values):
        raise TypeError(f"{name} has masked elements, which have no value")
    array = numpy.asarray(values)
    if array.dtype == float64:
        return array
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind not in "biuf":
        raise TypeError(f"{name} has elements of type {array.dtype}, which is not one of real numbers")
    with numpy.errstate(over="ignore"):
        numbers = array.astype(float64)
    kept = True
    if kind in "iu" and size == 8:
        far = array[(array > 2**53) | (array < -2**53)]
        kept = all(int(float(one)) == one for one in far.tolist())
    elif size > 8:
        kept = numpy.array_equal(numbers, array, equal_nan=True)
    if not kept:
        raise TypeError(f"{name} has elements of type {array.dtype} that no double holds exactly")
    return numbers


def pack(objects, shapes):
    """The array of a tuple of objects: pack(Input(...), input_shapes). Leading axes are those of a batch."""
    names = getattr(objects, "_fields", range(len(shapes)))
    parts = [_exact(value, name) for value, name in zip(objects, names)]
    lead = [part.shape[:part.ndim - len(shape)] for part, shape in zip(parts, shapes)]
    for part, shape, name in zip(parts, shapes, names):
        if part.shape[part.ndim - len(shape):] != shape:
            raise ValueError(f"{name} has shape {part.shape}, which does not end in {shape}")
    lead = numpy.broadcast_shapes(*lead)
    flat = [numpy.broadcast_to(part, lead + shape).reshape(lead + (math.prod(shape),))
            for part, shape in zip(parts, shapes)]
    return numpy.concatenate(flat, axis=-1)


def unpack(numbers, shapes):
    """The list of objects of an array: Output(*unpack(output, output_shapes))."""
    objects, first = [], 0
    for shape in shapes:
        size = math.prod(shape)
        objects.append(numbers[..., first:first + size].reshape(numbers.shape[:-1] + shape))
        first += size
    return objects


def _checked(numbers, count, name):
    numbers = _exact(numbers, name)
    if numbers.shape[-1:] != (count,):
        raise ValueError(f"{name} has shape {numbers.shape}; its last axis must have {count} numbers")
    return numbers

)";

// Heads of the two functions.
inline constexpr std::string_view python_preprocess = R"(
def $preprocess(parameters=()):
    """The constants of compute, for parameters whose last axis has $parameters numbers. Once, and again whenever a
    parameter changes."""
)";

inline constexpr std::string_view python_places =
    R"(    """The outputs, $outputs numbers in the last axis, for inputs whose last axis has $inputs; the axes before it are a
    batch, and are broadcast against those of the constants.)";

inline constexpr std::string_view python_guards_begin = R"(class GuardError(ValueError):
    """A guard does not hold: `number` is the first one that does not, `where` the index of the first such sample."""

    def __init__(self, number, where):
        self.number = number
        self.where = where
        super().__init__(f"guard {number} does not hold: {$guard_text(number)}")

    def __reduce__(self):
        """As pickle makes it again, in another process."""
        return type(self), (self.number, self.where), self.__dict__


def $guard_text(guard):
    """The condition of a guard and its places in the source."""
    text = [
)";
inline constexpr std::string_view python_guard = "        $text,\n";
inline constexpr std::string_view python_guards_end =
    "    ]\n    return text[guard - 1] if 0 < guard <= len(text) else \"\"\n";

} // namespace symreal
