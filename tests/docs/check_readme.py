"""README.md shows the code, the result of verify and the figures that there are.

   check_readme.py REPOSITORY GENERATED_C OUTPUT_OF_VERIFY
"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
readme = (root / "README.md").read_text()
code, verified = (pathlib.Path(name).read_text() for name in sys.argv[2:])
peers, results = ((root / name).read_text() for name in ("bench/peers/results.md", "bench/results.md"))
wrong = []
if re.search(r"^void compute\(.*?^}", code, re.MULTILINE | re.DOTALL)[0] not in readme:
    wrong.append("the generated code is not this")
without_library = lambda text: re.sub(r"(?<=functions of the original: ).*", "", text)  # each machine has its own
if without_library(verified) not in without_library(readme):
    wrong.append("verify does not say this")
source = "".join((root / "inputs/rotation/rotation.cpp").read_text().split())
before = readme.split("```cpp\n")[1].split("```")[0]
for part in before.split("...\n"):
    if "".join(part.split()) not in source:
        wrong.append(f"rotation.cpp does not have this: {part}")
# The second column is the original's operations, which bench/run has counted too.
names = {"forward kinematics": "fk", "inverse dynamics": "rnea", "mass matrix": "crba", "forward dynamics": "aba"}
for title, name in names.items():
    original = re.search(rf"^\| chain {name} \| (\d+) ", results, re.MULTILINE)[1]
    row = re.search(rf"^\| {title} \| .*$", peers, re.MULTILINE)[0]
    if not row.startswith(f"| {title} | {original} |") or row not in readme:
        wrong.append(f"the benchmarks have other figures: {title}")
print(*wrong, f"README.md: {len(wrong)} wrong", sep="\n")
sys.exit(1 if wrong else 0)
