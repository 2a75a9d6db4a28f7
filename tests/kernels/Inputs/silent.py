#!/usr/bin/env python3
"""The tool as if it had no errors: it takes each source, and generates nothing for it."""
import glob
import re
import sys

for path in glob.glob("batch.c") if sys.argv[1] == "generate" else []:
    with open(path) as file:
        names = re.findall(r"^ +(?:\(void\))?(k\d+)\(", file.read(), flags=re.M)
    for name in names:
        with open(f"out/{name}.c", "w") as file:
            file.write('/* symreal {"inputs": 0, "constants": 0} */\n')
