// Patterns of a package's Python code, besides the code shared with the plain module.
#pragma once

#include <string_view>

namespace symreal::tool {

inline constexpr std::string_view package_begin = R"(
import collections
import concurrent.futures
import ctypes
import math
import pathlib

import numpy
from numpy import float64

)";

inline constexpr std::string_view package_native = R"(
# CDLL releases the interpreter's lock during a call.
_native = ctypes.CDLL(str(pathlib.Path(__file__).with_name("_native.so")))
_native.symreal_preprocess.argtypes = [ctypes.c_int64] + [ctypes.c_void_p]*2
_native.symreal_preprocess.restype = None
_native.symreal_compute.argtypes = [ctypes.c_int64] + [ctypes.c_void_p]*5
_native.symreal_compute.restype = ctypes.c_int64


def _rows(numbers, count, name):
    return numpy.require(_checked(numbers, count, name), float64, "CA")


def _batch(input, constants, output):
    """Fills the output; the number of the first guard that does not hold, or 0, and the sample where it does not."""
    walk = numpy.array([output.shape[:-1], [step//8 for step in input.strides[:-1]],
                        [step//8 for step in constants.strides[:-1]]], numpy.int64)
    sample = numpy.zeros(1, numpy.int64)
    arrays = [array.ctypes.data for array in (walk, input, constants, output, sample)]
    return _native.symreal_compute(output.ndim - 1, *arrays), int(sample[0])

)";

inline constexpr std::string_view package_preprocess = R"(
def $preprocess(parameters=()):
    """The constants of compute, for parameters whose last axis has $parameters numbers. Once, and again whenever a
    parameter changes."""
    parameters = _rows(parameters, $parameters, "parameters")
    constants = numpy.empty(parameters.shape[:-1] + ($constants,))
    count = math.prod(parameters.shape[:-1])
    _native.symreal_preprocess(count, parameters.ctypes.data, constants.ctypes.data)
    return constants

)";

inline constexpr std::string_view package_compute = R"(
def $compute(input, constants=None, threads=1):
    """The outputs, $outputs numbers in the last axis, for inputs whose last axis has $inputs; the axes before it are a
    batch, and are broadcast against those of the constants. Several threads
    share the first axis of the batch."""
    constants = $preprocess() if constants is None else constants
    input, constants = _rows(input, $inputs, "input"), _rows(constants, $constants, "constants")
    shape = numpy.broadcast_shapes(input.shape[:-1], constants.shape[:-1])
    input = numpy.broadcast_to(input, shape + ($inputs,))
    constants = numpy.broadcast_to(constants, shape + ($constants,))
    output = numpy.empty(shape + ($outputs,))
    threads = min(threads, shape[0]) if shape else 1
    if threads > 1:
        ends = [shape[0]*k//threads for k in range(threads + 1)]
        parts = [slice(*pair) for pair in zip(ends, ends[1:])]
        with concurrent.futures.ThreadPoolExecutor(threads) as pool:
            found = list(pool.map(lambda part: _batch(input[part], constants[part], output[part]), parts))
        row = math.prod(shape[1:])
        found = [(guard, sample + part.start*row) for (guard, sample), part in zip(found, parts)]
    else:
        found = [_batch(input, constants, output)]
)";

inline constexpr std::string_view package_raise = R"(    failed = [one for one in found if one[0]]
    if failed:
        guard, sample = min(failed)
        raise GuardError(guard, tuple(int(i) for i in numpy.unravel_index(sample, shape)) if shape else ())
)";

inline constexpr std::string_view stub_begin = R"(
from typing import NamedTuple, Optional, Sequence

import numpy
from numpy.typing import ArrayLike, NDArray

)";

inline constexpr std::string_view stub_functions = R"(

def pack(objects: Sequence[ArrayLike], shapes: Sequence[tuple[int, ...]]) -> NDArray[numpy.float64]: ...
def unpack(
    numbers: NDArray[numpy.float64], shapes: Sequence[tuple[int, ...]]
) -> list[NDArray[numpy.float64]]: ...
def $preprocess(parameters: ArrayLike = ...) -> NDArray[numpy.float64]: ...
def $compute(
    input: ArrayLike, constants: Optional[ArrayLike] = ..., threads: int = ...
) -> NDArray[numpy.float64]: ...

)";

inline constexpr std::string_view stub_guards = R"(
class GuardError(ValueError):
    number: int
    where: tuple[int, ...]
    def __init__(self, number: int, where: tuple[int, ...]) -> None: ...

def $guard_text(guard: int) -> str: ...
)";

inline constexpr std::string_view test_pattern = R"(
"""The package computes what was recorded, and a batch as its samples one by one."""
import unittest
from math import inf, nan

import numpy

import $base as kernel

INPUT = [$input_values]
PARAMETERS = [$parameter_values]
OUTPUT = [$output_values]


class Test(unittest.TestCase):
    def setUp(self):
        self.constants = kernel.preprocess(PARAMETERS)

    def test_recorded_values(self):
        """Close, not equal: the mathematical library may be another one."""
        output = kernel.compute(INPUT, self.constants)
        numpy.testing.assert_allclose(output, OUTPUT, rtol=1e-9, atol=1e-9*numpy.nanmax(numpy.abs([1.0, *OUTPUT])))

    def test_batch(self):
        samples, singles = [], []
        for k in range(6):
            sample = numpy.array(INPUT)*(1 + k/64)
            try:
                singles.append(kernel.compute(sample, self.constants))
            except $refused:
                continue  # a guard does not hold there
            samples.append(sample)
        count = len(samples)
        for threads in 1, 2:
            batch = kernel.compute(numpy.array([samples, samples]), [[self.constants]]*2, threads)
            self.assertEqual(batch.shape, (2, count, kernel.output_count))
            for part in batch:
                numpy.testing.assert_array_equal(part, singles)

    def test_objects(self):
        objects = kernel.unpack(numpy.array(INPUT, float), kernel.input_shapes)
        numpy.testing.assert_array_equal(kernel.pack(kernel.Input(*objects), kernel.input_shapes), INPUT)

    def test_wrong_shape(self):
        with self.assertRaises(ValueError):
            kernel.compute(numpy.zeros(kernel.input_count + 1), self.constants)


if __name__ == "__main__":
    unittest.main()
)";

} // namespace symreal::tool
