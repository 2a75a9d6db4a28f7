"""Evaluates every counterexample of docs/reference/floating-point.md and finds the rules that it cites in rules.def.

   check_counterexamples.py FLOATING_POINT_MD RULES_DEF
"""
import re
import subprocess
import sys
import tempfile

page, rules = (open(name).read() for name in sys.argv[1:3])
# | `original` | `replacement` | `x = 1, y = 2` | value | value |
rows = re.findall(r"^\| `([^`]*)` \| `([^`]*)` \| `([a-z] = [^`]*)` \| (\S+) \| (\S+) \|", page, re.MULTILINE)
if len(rows) < 30:
    sys.exit(f"only {len(rows)} counterexamples found")

code = "#include <math.h>\n#include <stdio.h>\n"
for number, (before, after, operands, _, _) in enumerate(rows):
    code += f"static void row{number}(void) {{ volatile double {operands};"
    code += f' printf("%.17g %.17g\\n", (double)({before}), (double)({after})); }}\n'
code += "int main(void) { " + "".join(f"row{number}(); " for number in range(len(rows))) + "return 0; }\n"

with tempfile.TemporaryDirectory() as directory:
    source, program = directory + "/rows.c", directory + "/rows"
    open(source, "w").write(code)
    subprocess.run(["gcc", "-ffp-contract=off", "-fno-builtin", source, "-o", program, "-lm"], check=True)
    output = subprocess.run([program], capture_output=True, text=True, check=True).stdout.splitlines()

wrong = 0
for row, line in zip(rows, output):
    values = ["NaN" if "nan" in value else value for value in line.split()]
    if values != [row[3], row[4]] or values[0] == values[1]:
        print(f"{row[0]} -> {row[1]} at {row[2]}: the page says {row[3]}, {row[4]}; computed {line}")
        wrong += 1
for cited in re.findall(r"`(\((?:add|sub|mul|div|neg|abs|fmin|fmax|select|lt|gt|le|eq|ne|pow|sqrt) [^`]*\))`", page):
    if f'"{cited}"' not in rules:
        print(f"no such rule: {cited}")
        wrong += 1
print(f"{len(rows)} counterexamples, {wrong} wrong")
sys.exit(1 if wrong else 0)
