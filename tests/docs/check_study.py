"""check_study.py DOCS SMALL: the rows of the study's tables are those of its data, and so is what `bench/study --small` printed."""
import csv
import pathlib
import re
import sys

docs, small = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).read_text()
page = (docs / "multibody-study.md").read_text()


def count(row, stage):
    operations, calls = row[f"operations {stage}"], row[f"calls {stage}"]
    return operations if calls == "0" else f"{operations} + {calls}"


with open(docs / "multibody-study.csv", newline="") as file:
    data = {(row["kernel"], row["family"], row["bodies"]): row for row in csv.DictReader(file)}
wrong, rows, members = [], 0, 0
for heading, family in (("Spatial chain", "spatial"), ("Planar chain", "planar"), ("Binary tree", "binary"), ("Humanoid", "humanoid")):
    section = page.split(f"### {heading}\n")[1].split("\n#")[0]
    for kernel, n, before, after in re.findall(r"^\| (\w+) \| (\d+) \| ([\d +]+) \| ([\d +]+) \|", section, re.MULTILINE):
        rows += 1
        row = data.get((kernel, family, n))
        if not row or (before, after) != (count(row, "before"), count(row, "after")):
            wrong.append(f"{kernel} {family} {n}")
for kernel, family, n, before, after in re.findall(r"^(\w+) (\w+) (\d+): (\d+) operations -> (\d+),", small, re.MULTILINE):
    members += 1
    row = data.get((kernel, family, n))
    if not row or (before, after) != (row["operations before"], row["operations after"]):
        wrong.append(f"now: {kernel} {family} {n}")
for before, after in re.findall(r"^slider_crank: (\d+) operations -> (\d+),", small, re.MULTILINE):
    members += 1
    if not re.search(rf"^\| slider-crank, .*\| {before} \+ \d+ \| {after} \+ \d+ \|", page, re.MULTILINE):
        wrong.append("now: slider_crank")
print(*wrong, sep="\n")
print(f"{rows} rows of tables, {members} of the small setting, {len(wrong)} wrong")
sys.exit(bool(wrong))
