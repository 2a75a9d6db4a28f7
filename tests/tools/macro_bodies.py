#!/usr/bin/env python3
"""Prints what the runtime's macros name that a macro of the program may be called: macro_bodies.py HEADERS

Macros that the headers take back are their own matter.
"""
import os
import re
import sys

from runtime_names import KEYWORDS, RESERVED


def main():
    headers = os.path.join(sys.argv[1], "symreal")
    for name in sorted(os.listdir(headers)):
        if name.startswith("names_"):
            continue
        with open(os.path.join(headers, name), encoding="utf-8") as file:
            text = file.read().replace("\\\n", " ")
        text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
        text = re.sub(r"//[^\n]*", "", text)
        text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text)
        local = set(re.findall(r"#\s*undef\s+(\w+)", text))
        for macro, parameters, body in re.findall(r"^\s*#\s*define\s+(\w+)(?:\(([^)]*)\))?(.*)$", text, re.MULTILINE):
            names = set(re.findall(r"\b[A-Za-z_]\w*", body)) - {one.strip() for one in parameters.split(",")}
            for found in sorted(names - KEYWORDS - {"std"}):
                if macro not in local and not RESERVED.match(found):
                    print(f"{name}: {macro} names {found}")


if __name__ == "__main__":
    main()
