"""Writes the compile_commands.json of a program whose sources are compiled in different directories with different
flags, and one that compiles a source twice: make_program_database.py TREE"""
import json
import os
import sys

tree = os.path.abspath(sys.argv[1])
entries = [
    {"directory": tree + "/build", "file": "../src/main.cpp",
     "arguments": ["g++", "-I../lib", "-O2", "-c", "../src/main.cpp", "-o", "main.o"]},
    {"directory": tree + "/lib", "file": "scale.c",
     "arguments": ["gcc", "-std=c99", "-DFACTOR=3.0", "-c", "scale.c"]},
    {"directory": tree + "/src", "file": tree + "/lib/offset.cpp",
     "arguments": ["g++", "-I../generated", "-DFACTOR=5.0", "-fno-ipa-cp-clone", "-c", tree + "/lib/offset.cpp"]},
]
again = {**entries[1], "arguments": ["gcc", "-std=c99", "-DFACTOR=4.0", "-c", "scale.c"]}
for name, more in ("build", []), ("twice", [again]):
    os.makedirs(os.path.join(tree, name), exist_ok=True)
    with open(os.path.join(tree, name, "compile_commands.json"), "w") as out:
        json.dump(entries + more, out, indent=1)
