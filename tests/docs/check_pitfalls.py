"""Every row of docs/trust/pitfalls.md names a test that lit runs, and every test of tests/pitfalls is named in a row.
check_pitfalls.py REPOSITORY"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
page = root / "docs" / "trust" / "pitfalls.md"
rows = [line for line in page.read_text().splitlines() if line.startswith("| ") and not line.startswith("| Construct")]
named, wrong = set(), []
for row in rows:
    tests = [(page.parent / link).resolve() for link in re.findall(r"\]\((\.\./\.\./tests/[^)]+)\)", row)]
    if not tests:
        wrong.append(f"no test in the row: {row[:60]}")
    for test in tests:
        named.add(test)
        if not test.exists() or not re.search(r"\bRUN: ", test.read_text()):
            wrong.append(f"not a test: {test.relative_to(root)}")
for test in sorted((root / "tests" / "pitfalls").iterdir()):
    if test.is_file() and test.resolve() not in named:
        wrong.append(f"in no row: {test.relative_to(root)}")
print(f"{len(rows)} rows, {len(wrong)} wrong", *wrong, sep="\n")
sys.exit(1 if wrong or not rows else 0)
