import sys
import time

import numpy

import @BASE@ as kernel

values = numpy.loadtxt("values", ndmin=1)
first = values[0]
constants = kernel.preprocess(values[@INPUTS@:])
values = values[:@INPUTS@]
for line in sys.stdin:
    calls, total = int(line), 0.0
    begin = time.perf_counter()
    for i in range(calls):
        values[0] = first + 1e-7*(i & 15)
        total += kernel.compute(values, constants)[0]
    print((time.perf_counter() - begin)*1e9/calls, float(total), flush=True)
