#!/usr/bin/env python3
"""What the gradient of a weighted sum of all outputs by all inputs costs beside the function, in operations + - * / of `compute`.

  gradient_cost.py SYMREAL GRAPH... [--at-most TIMES]

Fails where one costs more than so many times the function: the function itself counts as the first.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def operations(symreal, graph, directory, *options):
    words = [symreal, "opt", graph, "--lang=c", "-o", f"{directory}/k.c", "--json", *options]
    said = subprocess.run(words, capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(f"{graph}: {said.stderr}")
    return json.loads(said.stdout)["operations"]["compute"]["arithmetic"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("symreal")
    parser.add_argument("graphs", nargs="+")
    parser.add_argument("--at-most", type=float, required=True)
    options = parser.parse_args()
    too_much = False
    for graph in options.graphs:
        labels = re.findall(r'^output "([^"]*)"', pathlib.Path(graph).read_text(), re.MULTILINE)
        with tempfile.TemporaryDirectory() as directory:
            alone = operations(options.symreal, graph, directory)
            both = operations(options.symreal, graph, directory, "--differentiate", f"vjp([{', '.join(labels)}])")
        print(f"{pathlib.Path(graph).stem}: {both} of {alone} operations, {both / alone:.2f} times")
        too_much = too_much or both > options.at_most * alone
    return 1 if too_much else 0


sys.exit(main())
