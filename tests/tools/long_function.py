#!/usr/bin/env python3
"""long_function.py COUNT [float]: prints a graph with so many nodes in one long function: sums, products, square roots,
truth values, selects and integers of 64 bits, whose values are used near and far. With float: without such integers."""
import random
import sys

count = int(sys.argv[1])
source = random.Random(5)
lines = ["%0 = input 0", "%1 = input 1", "%2 = wide_int %0", "%3 = wide 1481765933 1284865837", "%4 = wide_mul %2 %3",
         "%5 = wide_less %4 %2", "%6 = wide_value %4"]
if sys.argv[2:] == ["float"]:
    lines[2:] = ["%2 = abs %0", "%3 = abs %1", "%4 = add %2 %3", "%5 = lt %4 %2", "%6 = mul %4 %3"]
numbers = [0, 1, 6]


def recent():
    return f"%{source.choice(numbers[-20:])}"


def any_one():
    return f"%{source.choice(numbers)}"


for k in range(len(lines), count):
    if k % 97 == 0:
        text = f"lt {recent()} {any_one()}"
    elif k % 89 == 0:
        text = f"select {any_one()} {recent()} {recent()}"
    elif k % 311 == 0:
        text = f"select %5 {recent()} {recent()}"
    elif k % 7 == 0:
        text = f"abs {recent()}"
    else:
        text = f"add {recent()} {any_one()}" if k % 2 else f"mul 0.5 {recent()}"
    lines.append(f"%{k} = {text}")
    numbers.append(k)
print(f'symreal-graph 1\nkernel "k"\ninput "x" [2]\noutput "y" [{100}]')
print("\n".join(lines))
for slot in range(99):
    print(f"result {slot} %{count - 1 - 29 * slot}")
print(f"result 99 %6")
