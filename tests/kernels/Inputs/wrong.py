#!/usr/bin/env python3
"""The tool with a fault: in the code that it generates the first sum is a difference."""
import glob
import os
import re
import subprocess
import sys

status = subprocess.run([os.environ["SYMREAL_UNDER_TEST"], *sys.argv[1:]]).returncode
for path in glob.glob("out/*.c") if sys.argv[1] == "generate" else []:
    with open(path) as file:
        text = file.read()
    with open(path, "w") as file:
        file.write(re.sub(r"(?m)^(  (?:double const )?\w+(?:\[\d+\])? = .*?) \+ ", r"\1 - ", text, count=1))
sys.exit(status)
