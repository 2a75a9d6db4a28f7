import sys
import time

import numpy

import @BASE@ as kernel

values = numpy.loadtxt("values", ndmin=1)
first = values[0]
constants = kernel.preprocess(values[@INPUTS@:])
for line in sys.stdin:
    calls = int(line)
    samples = numpy.tile(values[:@INPUTS@], (calls, 1))
    samples[:, 0] = first + 1e-7*(numpy.arange(calls) & 15)
    begin = time.perf_counter()
    output = kernel.compute(samples, constants)
    print((time.perf_counter() - begin)*1e9/calls, float(output[:, 0].sum()), flush=True)
