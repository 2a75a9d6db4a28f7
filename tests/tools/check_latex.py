#!/usr/bin/env python3
"""check_latex.py FILE...: braces, environments and \text are closed in each equation, and no line has a bare special character."""
import re
import sys

failed = False
for path in sys.argv[1:]:
    text = "\n".join(line for line in open(path).read().splitlines() if not line.startswith("%"))
    faults, open_environments, depth = [], [], 0
    for token in re.finditer(r"\\(begin|end)\{([^}]*)\}|\\.|[{}#&%$~^_]", text):
        what, line = token[0], text.count("\n", 0, token.start()) + 1
        if token[1] == "begin":
            open_environments.append((token[2], depth))
        elif token[1] == "end":
            if not open_environments or open_environments.pop() != (token[2], depth):
                faults.append(f"{line}: {what} closes another")
        elif what in "{}":
            depth += 1 if what == "{" else -1
        elif what in "#%$~" or (what == "&" and [name for name, _ in open_environments][-1:] != ["cases"]):
            faults.append(f"{line}: {what}")
        elif what in "^_" and text[token.end()] != "{":
            faults.append(f"{line}: {what} without a brace")
        elif what in "^_" and not open_environments:
            faults.append(f"{line}: {what} outside of an equation")
    if depth or open_environments:
        faults.append(f"left open: {depth} braces, {open_environments}")
    for fault in faults[:5]:
        print(f"{path}: {fault}")
    failed = failed or bool(faults)
sys.exit(1 if failed else 0)
