#!/usr/bin/env python3
"""Prints -DNAME=@ for each name in the runtime's headers that a program may give to a macro: runtime_names.py HEADERS
SOURCE...

Names that the sources use are left out. `@` is no C: where such a macro is expanded, nothing compiles.
"""
import os
import re
import sys

KEYWORDS = set("""
alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t class co_await
co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default defined delete
do double dynamic_cast else enum explicit export extern false final float for friend goto if import inline int long
module mutable namespace new noexcept not not_eq nullptr operator or or_eq override private protected public register
reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct switch template
this thread_local throw true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor
xor_eq
""".split())
RESERVED = re.compile(r"_[A-Z]|.*__|[Ss]ymreal|SYMREAL_|REAL$|REAL_|MBD_")
# Macros of the C library, which its own headers use.
LIBRARY = {"INFINITY", "stderr", "stdout", "va_copy", "va_end"}


def identifiers(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"#\s*(include|pragma).*", "", text)
    text = re.sub(r'"(\\.|[^"\\\n])*"', '""', text)
    names = set(re.findall(r"(?<![\w'])[A-Za-z_]\w*", text))
    return names | {name.removeprefix("__builtin_") for name in names} - {""}


def main():
    headers = os.path.join(sys.argv[1], "symreal")
    names = set().union(*(identifiers(os.path.join(headers, name)) for name in os.listdir(headers)
                          if not name.startswith("names_")))
    own = set().union(*map(identifiers, sys.argv[2:]))
    for name in sorted(names - KEYWORDS - own - LIBRARY - {"std"}):
        if not RESERVED.match(name):
            print(f"-D{name}=@")


if __name__ == "__main__":
    main()
