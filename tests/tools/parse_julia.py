#!/usr/bin/env python3
"""parse_julia.py FILE...: parses Julia with tree-sitter's grammar; tells the lines that it does not take, and functions of C's
library (c_NAME) that are called without a definition."""
import re
import sys

import tree_sitter
import tree_sitter_julia

parser = tree_sitter.Parser(tree_sitter.Language(tree_sitter_julia.language()))


def faults(node):
    if node.is_error or node.is_missing:
        yield node
    elif node.has_error:
        for child in node.children:
            yield from faults(child)


failed = False
for path in sys.argv[1:]:
    text = open(path, "rb").read()
    lines = text.decode().splitlines()
    found = [f"{path}:{node.start_point[0] + 1}: {lines[node.start_point[0]]}" for node in faults(parser.parse(text).root_node)]
    called, defined = set(re.findall(rb"\bc_\w+(?=\()", text)), set(re.findall(rb"^(c_\w+)\(.*\) = ", text, re.MULTILINE))
    found += [f"{path}: {name.decode()} is not defined" for name in sorted(called - defined)]
    print("\n".join(found[:10]) or f"parsed {path.rsplit('/', 1)[-1]}")
    failed = failed or bool(found)
sys.exit(1 if failed else 0)
