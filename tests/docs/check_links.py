"""Follows the relative links in README.md, docs/ and the other pages.   check_links.py REPOSITORY"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
count = broken = 0
for page in [root / "README.md", *root.glob("docs/*.md"), *root.glob("bench/*.md"), *root.glob("inputs/*.md")]:
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text()):
        if "://" in target:
            continue
        count += 1
        if not (page.parent / target).exists():
            print(f"{page.relative_to(root)}: {target} does not exist")
            broken += 1
print(f"{count} links, {broken} broken")
sys.exit(1 if broken else 0)
