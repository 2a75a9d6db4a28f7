#!/usr/bin/env python3
"""Writes names_hide.h and names_show.h: hide_names.py COMPILER HEADERS

The headers of a symbolic program, and those of the standard library that they include, are read after the macros of the
command line, and maybe after some of the program. Between these two headers no macro of the program has a name that
stands in them. Names that a program may not define are left out, and macros of the library, which it uses itself.
"""
import os
import re
import subprocess
import sys

# Every way to read them. With each standard come names of the library.
MODES = [["-DMBD_REPLAY"], ["-DMBD_SYMBOLIC"], ["-DMBD_SYMBOLIC", "-DSYMREAL_BEFORE_CXX20"], ["-DMBD_SYMBOLIC", "-DSYMREAL_SOURCE_OF_C"]]
STANDARDS = ["-std=gnu++20", "-std=gnu++23"]

RESERVED = re.compile(r"_[A-Z]|.*__|[Ss]ymreal|SYMREAL_|REAL_|MBD_")
# Words that are no macro names to a compiler of C++.
OPERATORS = {"and", "and_eq", "bitand", "bitor", "compl", "defined", "not", "not_eq", "or", "or_eq", "xor", "xor_eq"}


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    return re.sub(r"//[^\n]*", "", text)


def identifiers(text):
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text)
    return set(re.findall(r"(?<![\w'])[A-Za-z_]\w*", text))


def preprocessed(compiler, headers, words):
    command = [compiler, "-x", "c++", "-E", "-P", "-w", "-I", headers, "-include", "symreal/real.h", *words, "-"]
    # <complex> of C++ is what C's <complex.h> includes, and has all of strings and streams.
    return subprocess.run(command, input="#include <complex>\n", capture_output=True, text=True, check=True).stdout


def main():
    compiler, headers = sys.argv[1:]
    own = os.path.join(headers, "symreal")
    # The headers include them.
    for name in ("names_hide.h", "names_show.h"):
        open(os.path.join(own, name), "w").close()
    names, macros = set(), set()
    for name in os.listdir(own):
        if name.startswith("names_"):
            continue
        with open(os.path.join(own, name), encoding="utf-8") as file:
            names |= identifiers(re.sub(r"#\s*include.*", "", without_comments(file.read())))
    for standard in STANDARDS:
        for mode in MODES:
            names |= identifiers(preprocessed(compiler, headers, [standard, *mode]))
            defined = preprocessed(compiler, headers, [standard, *mode, "-dM"])
            macros |= set(re.findall(r"#define (\w+)", defined))
    constants = {name for name in macros if name.startswith("M_")}
    hidden = sorted(name for name in names - macros - OPERATORS | constants if not RESERVED.match(name))
    origin = "/* Written by cmake/hide_names.py, which says what for. */\n"
    with open(os.path.join(own, "names_hide.h"), "w", encoding="utf-8") as file:
        file.write(origin)
        for name in hidden:
            file.write(f'#ifdef {name}\n#pragma push_macro("{name}")\n#undef {name}\n'
                       f"#define SYMREAL_HIDDEN_{name}\n#endif\n")
    with open(os.path.join(own, "names_show.h"), "w", encoding="utf-8") as file:
        file.write(origin)
        for name in hidden:
            file.write(f'#ifdef SYMREAL_HIDDEN_{name}\n#undef SYMREAL_HIDDEN_{name}\n'
                       f'#pragma pop_macro("{name}")\n#endif\n')


if __name__ == "__main__":
    main()
