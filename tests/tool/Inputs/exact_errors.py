"""exact_errors.py RESULT: the largest errors that `verify --exact` tells of the kernel in verify_exact.cpp, against decimal arithmetic."""
import decimal
import json
import math
import sys

FORMULAS = {"root": lambda p, q, sqrt: sqrt(p * p + q) - p, "sum": lambda p, q, sqrt: p / 3 + q / 3 + p / 7}

decimal.getcontext().prec = 60
with open(sys.argv[1]) as file:
    result = json.load(file)
named = {one["sample"]: one["inputs"] for one in result["named"]}
for output, told in zip(result["outputs"], result["errors"]["outputs"], strict=True):
    p, q = named[told["sample"]]
    formula = FORMULAS[output["label"]]
    exact = formula(decimal.Decimal(p), decimal.Decimal(q), decimal.Decimal.sqrt)
    error = float(abs(decimal.Decimal(formula(p, q, math.sqrt)) - exact) / max(abs(exact), 1))
    assert 0 < error <= told["original"] * (1 + 1e-12), (error, told)
    assert told["original"] < told["generated"] or math.isclose(error, told["original"], rel_tol=1e-12), (error, told)
