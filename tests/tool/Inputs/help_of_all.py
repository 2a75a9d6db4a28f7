"""Whether each option of each subcommand stands under a title, and each subcommand has two examples.   help_of_all.py SYMREAL"""
import re
import subprocess
import sys


def shown(*words):
    return subprocess.run([sys.argv[1], *words], capture_output=True, text=True, check=True).stdout


names = re.findall(r"^  ([a-z][a-z-]+) {2,}", shown("--help").split("Subcommands:")[1], re.MULTILINE)
without = 0
for name in names:
    text = shown(name, "--help")
    for option in re.findall(r"^  (?:-\w,)?(-[-\w]+)", text.split("\nOptions:\n")[1].split("\n\n")[0], re.MULTILINE):
        if option != "--help":
            print(f"{name} {option}: no title")
            without += 1
    if text.count(f"\n  symreal {name}") != 2:
        print(f"{name}: not two examples")
        without += 1
print(f"{len(names)} subcommands, {without} options without a title")
