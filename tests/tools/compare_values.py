#!/usr/bin/env python3
"""Compares the numbers on standard input with expected ones, in order.

  program | compare_values.py --values="1 2.5 -3" [--tolerance 1e-12]
  program | compare_values.py --values-file FILE
  program | compare_values.py --csv FILE --column value --where algorithm=RNEA --where N=6
  compare_values.py --csv FILE --where algorithm=RNEA --each N=2,6,16 program

--each runs the program itself, with each of the values in turn as its argument.

A number agrees when it differs by at most the tolerance times the larger of 1 and the expected magnitude. Exit status 1
names each number that does not, or that one list is shorter.
"""
import argparse
import csv
import math
import subprocess
import sys


def expected_values(options, each=()):
    if options.values is not None:
        return [float(word) for word in options.values.split()]
    if options.values_file is not None:
        with open(options.values_file) as file:
            return [float(word) for word in file.read().split()]
    conditions = [condition.split("=", 1) for condition in (*options.where, *each)]
    with open(options.csv, newline="") as file:
        rows = [row for row in csv.DictReader(file) if all(row[name] == value for name, value in conditions)]
    return [float(row[options.column]) for row in rows]


def agrees(got, wanted, tolerance):
    if math.isnan(wanted) or math.isnan(got):
        return math.isnan(wanted) and math.isnan(got)
    return got == wanted or abs(got - wanted) <= tolerance * max(1.0, abs(wanted))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--values")
    source.add_argument("--values-file")
    source.add_argument("--csv")
    parser.add_argument("--column", default="value")
    parser.add_argument("--where", action="append", default=[], metavar="COLUMN=VALUE")
    parser.add_argument("--tolerance", type=float, default=1e-12)
    parser.add_argument("--each", metavar="COLUMN=VALUE,...")
    parser.add_argument("program", nargs="?")
    options = parser.parse_args()
    if (options.each is None) != (options.program is None):
        parser.error("--each and a program belong together")
    if not options.program:
        return compare(options, expected_values(options), sys.stdin.read())
    column, values = options.each.split("=")
    return max(compare(options, expected_values(options, [f"{column}={value}"]),
                       subprocess.run([options.program, value], stdout=subprocess.PIPE, text=True, check=True).stdout)
               for value in values.split(","))


def compare(options, wanted, text):
    got = [float(word) for word in text.split()]
    failures = [f"number {i}: {g!r}, expected {w!r}" for i, (g, w) in enumerate(zip(got, wanted))
                if not agrees(g, w, options.tolerance)]
    if len(got) != len(wanted):
        failures.append(f"{len(got)} numbers, expected {len(wanted)}")
    if not wanted:
        failures.append("nothing was expected")
    print("\n".join(failures), end="\n" if failures else "", file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
