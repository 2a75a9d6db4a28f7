"""The pages docs/contribute/add-*.md against the tables and the tree:

   the files that a page lists are there; those that it says are new, if the tables have the rows that it shows; they are as
   many as it says;
   the commit that it names as an example changes only files that it lists, where the history is at hand;
   a row that it shows has the columns of the table's legend, and is the table's own if the table has one of that name.

   check_add_pages.py REPOSITORY
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1]).resolve()
wrong = []


def arguments(text, begin):
    """The arguments of the macro call whose '(' is at `begin`, separated by commas outside of strings and parentheses."""
    result, depth, quoted, at = [""], 0, False, begin
    while True:
        letter = text[at]
        if letter == '"' and text[at - 1] != "\\":
            quoted = not quoted
        if not quoted and letter in "([{":
            depth += 1
        if not quoted and letter in ")]}":
            depth -= 1
        if depth == 0:
            return [" ".join(one.split()) for one in result]
        if letter == "," and depth == 1 and not quoted:
            result.append("")
        elif at > begin:
            result[-1] += letter
        at += 1


def rows(text, macro):
    return [arguments(text, found.end() - 1) for found in re.finditer(rf"^{macro}\(", text, re.MULTILINE)]


# By macro: the columns that the legend at the head of the table names, and the rows.
tables = {}
for path in sorted(path for floor in ("engine", "runtime", "rewrite", "tool") for path in root.glob(floor + "/**/*.def")):
    text = path.read_text()
    legend = re.search(r"^//.*?\b([A-Z][A-Z_]+)\(((?:\w+, )*\w+)\)", text, re.MULTILINE)
    if legend:
        tables[legend[1]] = (path.name, legend[2].split(", "), rows(text, legend[1]))

without_floor = lambda name: "/".join(pathlib.Path(name).parts[-2:])
there = {without_floor(path) for floor in root.iterdir() if floor.name not in ("build", ".git") for path in floor.rglob("*")}
pages = sorted(root.glob("docs/contribute/add-*.md"))
shown = 0


def files_of_commit(commit):
    """None where there is no history, as in an archive of the sources."""
    shown = subprocess.run(["git", "-C", root, "show", "--name-only", "--format=", commit], capture_output=True, text=True)
    return set(shown.stdout.split())


for page in pages:
    text = page.read_text()
    files = re.search(r"^\| File \| Change \|\n\|---\|---\|\n((?:\|.*\n)+)", text, re.MULTILINE)
    count = re.search(r"^Files that change: (\d+)\.(?: An example: `git show --stat (\w+)`\.)?$", text, re.MULTILINE)
    if not files or not count:
        wrong.append(f"{page.name}: does not say which files change, or how many")
        continue
    # What the page shows is in the tables: then its new files are there as well.
    shows = [row in known for macro, (_, _, known) in tables.items() for row in rows(text, macro)]
    is_added = bool(shows) and all(shows)
    listed = [line.split("|")[1:3] for line in files[1].splitlines()]
    if len(listed) != int(count[1]):
        wrong.append(f"{page.name}: says {count[1]} files and lists {len(listed)}")
    names = {link[1] if (link := re.search(r"\[(.*?)\]", name)) else name.strip() for name, _ in listed}
    for name in files_of_commit(count[2]) if count[2] else ():
        # Files are moved later, and some are removed.
        if without_floor(name) in there and without_floor(name) not in map(without_floor, names):
            wrong.append(f"{page.name}: its example {count[2]} changes {name}, which it does not list")
    for name, change in listed:
        link = re.search(r"\[(.*?)\]\((.*?)\)", name)
        if link and (page.parent / link[2]).resolve() != (root / link[1]):
            wrong.append(f"{page.name}: {link[1]} is not where the link leads")
        if link and not (root / link[1]).exists():
            wrong.append(f"{page.name}: {link[1]} does not exist")
        if not link and "/" in name:
            new = root / name.strip()
            if "new: " not in change or new.exists() != is_added or not new.parent.is_dir():
                wrong.append(f"{page.name}: {name.strip()} is not a new file of an existing folder, or its row is missing")
    for macro, columns in re.findall(r"`([A-Z][A-Z_]+)\(((?:\w+, )*\w+)\)`", text):
        if macro not in tables or columns.split(", ") != tables[macro][1]:
            wrong.append(f"{page.name}: no table has the columns {macro}({columns})")
    for macro, (table, columns, known) in tables.items():
        for row in rows(text, macro):
            shown += 1
            same = [one for one in known if one[0] == row[0]]
            if len(row) != len(columns):
                wrong.append(f"{page.name}: the row {row[0]} has {len(row)} columns, those of {table} have {len(columns)}")
            elif same and row not in known:
                wrong.append(f"{page.name}: {table} has another row {row[0]}")
print(*wrong, f"{len(pages)} pages, {shown} rows, {len(wrong)} wrong", sep="\n")
sys.exit(1 if wrong or not shown else 0)
