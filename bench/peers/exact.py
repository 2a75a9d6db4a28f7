"""The kernels in extended precision: chain.py on numbers of 40 digits, from the table's doubles on."""
import mpmath

import chain
import generate
from work import WORK, digest, remembered

LIMIT = {"fk": 1000, "rnea": 256, "crba": 64, "aba": 64}  # joints; beyond it takes minutes
VECTORS = 4


def outputs(kernel, joints, vectors):
    """Of the first vectors, or None where it would take too long."""
    if joints > LIMIT[kernel]:
        return None
    mpmath.mp.dps = 40
    method, parts = generate.KERNELS[kernel]

    def make():
        robot = chain.Chain(joints, mpmath.sin, mpmath.cos, mpmath.mpf)
        result = []
        for vector in vectors[:VECTORS]:
            arguments = [[mpmath.mpf(x) for x in vector[i * joints:(i + 1) * joints]] for i in range(parts)]
            result.append([mpmath.nstr(mpmath.mpf(x), 36) for x in getattr(robot, method)(*arguments)])
        return result
    with open(chain.__file__) as file:
        texts = remembered(digest("exact", kernel, joints, VECTORS, file.read(), vectors), make)
    return [[mpmath.mpf(text) for text in of_vector] for of_vector in texts]


def error(references, numbers, count):
    """The largest over vectors and outputs, relative to the vector's largest output."""
    if references is None:
        return None
    worst = 0
    for place, reference in enumerate(references):
        scale = max(map(abs, reference))
        for true, value in zip(reference, numbers[place * count:(place + 1) * count]):
            worst = max(worst, float(abs(mpmath.mpf(value) - true) / scale))
    return worst
