"""Follows the relative links in all pages, to their sections as well.   check_links.py REPOSITORY"""
import functools
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1]).resolve()


def without_code(text):
    text = re.sub(r"^( *)(```+|~~~+).*?^ *\2[^\n]*$", "", text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"(`+)(?!`).+?(?<!`)\1(?!`)", lambda code: re.sub(r"[\[\]]", " ", code[0]), text)


@functools.cache
def sections(page):
    """The anchors of a page's headings, as GitHub makes them: in lower case, without signs, - for blanks, numbered."""
    anchors, met = set(), {}
    for heading in re.findall(r"^ {0,3}#{1,6}\s+(.*?)\s*#*\s*$", without_code(page.read_text()), re.MULTILINE):
        heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)  # a link's text
        anchor = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        count = met.get(anchor, 0)
        met[anchor] = count + 1
        anchors.add(f"{anchor}-{count}" if count else anchor)
    return anchors


pages = subprocess.check_output(["git", "ls-files", "*.md"], cwd=root, text=True).split()
count = 0
broken = []
for page in (root / name for name in pages):
    for target in re.findall(r"\]\(<?([^)\s>]+)[^)]*\)", without_code(page.read_text())):
        if "://" in target or target.startswith("mailto:"):
            continue
        count += 1
        path, _, section = target.partition("#")
        file = page.parent / path if path else page
        if not file.exists():
            broken.append(f"{page.relative_to(root)}: {target} does not exist")
        elif section and (file.suffix != ".md" or section not in sections(file)):
            broken.append(f"{page.relative_to(root)}: {target}: no such section")
print(f"{len(pages)} pages, {count} links, {len(broken)} broken", *broken, sep="\n")
sys.exit(1 if broken or not count else 0)
