#!/usr/bin/env python3
"""The compiler of C++, which optimises nothing: half of the time for a symbolic program, which records the same.

Not for sources in C++: the library's templates for integers hand constants to builtins, which the compiler computes where it
optimises: cbrt(5).
"""
import os
import sys

words = ["c++", *sys.argv[1:]]
if "-DMBD_SYMBOLIC" in words:
    words.append("-O0")
os.execvp("c++", words)
