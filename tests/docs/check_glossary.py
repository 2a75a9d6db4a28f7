"""docs/internals/glossary.md against the sources: words are in order and stand in their file; a type is declared there alone.

   check_glossary.py REPOSITORY
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1]).resolve()
page = root / "docs/internals/glossary.md"
rows = re.findall(r"^\| ([a-z][^|]*?) \| [^|]+ \| (?:`(\w+)`)? ?\| \[[^]]*\]\(([^)]+)\) \|$", page.read_text(), re.MULTILINE)
wrong = [] if len(rows) == page.read_text().count("\n| ") - 1 else ["a row has another form"]
words = [word for word, _, _ in rows]
if words != sorted(set(words)):
    wrong.append("the words are not in order, or stand twice")
names = subprocess.check_output(["git", "ls-files", "*.h", "*.cpp"], cwd=root, text=True).split()
product = [root / name for name in names if name.split("/")[0] in ("engine", "runtime", "rewrite", "program", "verify", "tool")]
declared = {}  # by type: the files that define it
for path in product:
    for name in re.findall(r"^\s*(?:template <[^>]*> )?(?:struct|class|enum class) (\w+)[^;{]*\{", path.read_text(), re.MULTILINE):
        declared.setdefault(name, set()).add(path)
for word, name, link in rows:
    path = (page.parent / link).resolve()
    text = re.sub(r"[\s/-]+", " ", path.read_text()).lower() if path.exists() else ""
    if word not in text and word.replace(" ", "") not in text:
        wrong.append(f"{word}: {link} does not say it")
    if name and declared.get(name) != {path}:
        wrong.append(f"{word}: {name} is declared in {sorted(str(one.relative_to(root)) for one in declared.get(name, ()))}")
print(f"{len(rows)} words, {len(wrong)} wrong", *wrong, sep="\n")
sys.exit(1 if wrong or not rows else 0)
