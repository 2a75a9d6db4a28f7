"""Graphs and schedules, each with the place and the beginning of its error: meanings.py SYMREAL FILE DIRECTORY."""
import pathlib
import re
import subprocess
import sys

symreal, file, directory = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
faults = 0
cases = re.split(r"(?m)^=== (.*)\n", file.read_text())[1:]
for expected, text in zip(cases[::2], cases[1::2]):
    path = directory / "case"
    path.write_text(text)
    done = subprocess.run([symreal, "opt", path, "--lang=c"], capture_output=True, text=True)
    place, message = expected.split(": ", 1)
    found = re.search(r"^.*case(:[0-9:]*)?: error: (.*)$", done.stderr, re.MULTILINE)
    told = f"{(found.group(1) or ':')[1:]}: {found.group(2)}" if found else f"status {done.returncode}: {done.stderr}{done.stdout[:200]}"
    if done.returncode != 1 or not told.startswith(f"{place}: {message}"):
        faults += 1
        print(f"expected {expected}\n   found {told}")
print(f"all {len(cases) // 2} as expected" if faults == 0 else f"{faults} faults")
