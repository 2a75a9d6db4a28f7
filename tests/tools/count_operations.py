#!/usr/bin/env python3
"""Checks how many + - * / the report of `symreal generate --json` leaves in compute.

  count_operations.py REPORT.json --at-most N
"""
import argparse
import json
import sys


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report")
    parser.add_argument("--at-most", type=int, required=True)
    options = parser.parse_args()
    with open(options.report) as file:
        kernel = json.load(file)["kernels"][0]
    left = sum(kernel["operations"]["compute"].get(name, 0) for name in ("add", "sub", "mul", "div"))
    print(f"{kernel['kernel']}: {left} of {options.at_most} operations")
    return 0 if 0 < left <= options.at_most else 1


sys.exit(main())
