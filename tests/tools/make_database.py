"""Writes a compile_commands.json as builds do, and a source with an unusual name: make_database.py TREE"""
import json
import os
import sys

tree = os.path.abspath(sys.argv[1])
build = os.path.join(tree, "build")
os.makedirs(build, exist_ok=True)
with open(os.path.join(tree, "src/a name 'with' quotes.cpp"), "w") as out:
    out.write('#include "body.h"\ndouble quoted_name(double x) { return x > 1 ? 1 : x; }\n')
entries = [
    # A wrapper, a response file, flags that only GCC knows, relative paths.
    {"directory": build, "file": "../src/one.cpp",
     "command": "ccache g++ @../flags.rsp -fno-ipa-cp-clone -mpreferred-stack-boundary=4 -fabi-version=11 -MD -MF one.d -O2 -c ../src/one.cpp -o one.o"},
    # The same source in another configuration.
    {"directory": build, "file": "../src/one.cpp", "output": "one_more.o",
     "arguments": ["g++", "-I../include", "-DSECOND=2.0", "-c", "../src/one.cpp", "-o", "one_more.o"]},
    {"directory": build, "file": os.path.join(tree, "src/two.c"),
     "arguments": ["gcc", "-DWITH_SPIN", "-c", os.path.join(tree, "src/two.c"), "-o", "two.o"]},
    {"directory": os.path.join(tree, "src"), "file": "a name 'with' quotes.cpp",
     "arguments": ["c++", "-I", os.path.join(tree, "include"), "-c", "a name 'with' quotes.cpp"]},
    {"directory": tree, "file": "src/start.S", "arguments": ["gcc", "-c", "src/start.S"]},
]
with open(os.path.join(build, "compile_commands.json"), "w") as out:
    json.dump(entries, out, indent=1)
