#!/usr/bin/env python3
"""Writes macros.h and real.h, of a rewritten source, from the table that describes it: mode_macros.py TABLE HEADERS"""
import os
import re
import sys

MODES = {"numeric": ["numeric"], "symbolic": ["symbolic"], "replay": ["replay"], "plain": ["numeric", "replay"],
         "live": ["symbolic", "replay"], "of_c": ["of_c"]}
TEXT = re.compile(rf"({'|'.join(MODES)})\b ?(.*)")
HEAD = """\
/* Written by cmake/mode_macros.py from runtime/macros.def, which says what {what}. */
#ifndef SYMREAL_{guard}_H
#define SYMREAL_{guard}_H
"""


def read_table(path):
    """Rows as (comment, name, parameters, lines of text by mode)."""
    rows, comment = [], []
    with open(path, encoding="utf-8") as file:
        for line in file.read().splitlines():
            if line.startswith("//"):
                comment.append(line[3:])
                continue
            head = re.match(r"(\w+)(\([^)]*\))?\s*(.*)", line)
            if head:
                rows.append((comment, head[1], head[2] or "", {}))
                line = "  " + head[3]
            comment = []
            if text := TEXT.fullmatch(line[2:]):
                added = [text[2]]
                rows[-1][3].update(dict.fromkeys(MODES[text[1]], added))
            elif line.strip():
                added.append(line[4:])
    return rows


def defined(name, parameters, lines):
    text = " \\\n".join(lines).replace("$", "__VA_ARGS__")
    if not text and parameters:
        parameters = "(...)"  # a call may leave the last one out, which a pedantic compiler of C refuses
    return f"#define {name}{parameters} {text}".rstrip() + "\n"


def macros(rows, mode):
    result = ""
    for comment, short, parameters, texts in rows:
        name = short if short.startswith("SYMREAL_") else "SYMREAL_" + short
        default = ["$"] if name != short and "..." in parameters else []
        text = defined(name, parameters, texts.get(mode, default))
        if mode != "numeric" and "of_c" in texts:
            text = f"#ifdef SYMREAL_SOURCE_OF_C\n{defined(name, parameters, texts['of_c'])}#else\n{text}#endif\n"
        if comment and mode == "symbolic":
            result += "/* " + "\n   ".join(comment) + " */\n"
        result += text
    return result


def main():
    table, headers = sys.argv[1:]
    rows = read_table(table)
    with open(os.path.join(headers, "macros.h"), "w", encoding="utf-8") as file:
        file.write(HEAD.format(guard="MACROS", what="each macro is in each mode")
                   + "#ifdef MBD_SYMBOLIC\n#include <symreal/macro_names.h>\n" + macros(rows, "symbolic")
                   + "#elif defined(MBD_REPLAY)\n#include <symreal/macro_names.h>\n" + macros(rows, "replay")
                   + "#else\n" + macros(rows, "numeric") + "#endif\n\n#endif\n")
    with open(os.path.join(headers, "real.h"), "w", encoding="utf-8") as file:
        short = [name for _, name, _, _ in rows if not name.startswith("SYMREAL_")]
        file.write(HEAD.format(guard="REAL", what="they mean") + '\n#include "macros.h"\n\n'
                   + "".join(f"#define {name} SYMREAL_{name}\n" for name in short) + "\n#endif\n")


if __name__ == "__main__":
    main()
