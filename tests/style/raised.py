"""Every diagnostic of the table is raised by a test that expects it by its id.   raised.py REPOSITORY SYMREAL

An expectation is a line for FileCheck with the id in brackets. In a unit test it is the id in brackets in the expression of a
death test, or its name in an EXPECT_... Each file of tests/bad_input expects at least one.
"""
import json
import pathlib
import re
import subprocess
import sys

root, symreal = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
rows = json.loads(subprocess.check_output([symreal, "explain", "--json"], text=True))
summaries = {row["id"]: row["summary"] for row in rows}
table = (root / "engine/diagnostics/diagnostics.def").read_text()
numbers = dict(re.findall(r"^DIAGNOSTIC\((\w+), (\d+)", table, re.MULTILINE))


def expected_by_lit(text):
    """The ids in the directives of FileCheck: those with the prefix CHECK, and with others that a command names."""
    commands = " ".join(re.findall(r"\b(?:RUN|DEFINE):(.*)", text))
    found = set()
    for line in text.splitlines():
        directive = re.match(r"[\s/*#;]*([A-Z]\w*)(?:-DAG|-NEXT|-SAME|-LABEL|-COUNT-\d+)?:(.*)", line)
        if directive and (directive[1] == "CHECK" or re.search(rf"[=, ]{directive[1]}\b", commands)):
            found.update(re.findall(r"\[(SYM\d{3})\]", directive[2]))
    return found


def expected_by_unit(text):
    found = set(re.findall(r"\\\\\[(SYM\d{3})\\\\\]", text))
    for name in re.findall(r"EXPECT_\w+\(.*DiagnosticId::(\w+)", text):
        found.add(f"SYM{int(numbers[name]):03}")
    return found


expected, wrong = set(), []
for test in sorted((root / "tests").rglob("*")):
    room, *inner = test.relative_to(root / "tests").parts
    if not test.is_file() or "Inputs" in inner or room in ("tools", "mutation"):
        continue
    if room == "unit":
        if test.suffix == ".cpp":
            expected |= expected_by_unit(test.read_text())
    elif test.suffix in (".test", ".cpp", ".c", ".graph", ".txt", ".facts"):
        found = expected_by_lit(test.read_text())
        expected |= found
        if room == "bad_input" and not found:
            wrong.append(f"{test.relative_to(root)} expects no diagnostic by its id")

wrong += [f"{one}: {summaries[one]}: no test expects it" for one in sorted(summaries.keys() - expected)]
wrong += [f"{one} is expected and does not exist" for one in sorted(expected - summaries.keys())]
print(f"{len(summaries)} diagnostics, {len(wrong)} wrong", *wrong, sep="\n")
sys.exit(1 if wrong or not summaries else 0)
