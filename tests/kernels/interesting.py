#!/usr/bin/env python3
"""interesting.py CASE CANDIDATE: ends with 0 if the fault of the case is in the candidate (kernels/reduce.py)."""
import pickle
import sys

with open(sys.argv[1], "rb") as file:
    case = pickle.load(file)
sys.exit(0 if case.is_in(sys.argv[2]) else 1)
