"""Compares what rooms include and call with what the build says that each room sees.

usage: rooms.py SOURCE BUILD            checks; prints each include, and each symbol, that looks up
       rooms.py SOURCE BUILD --draw     prints the graph of rooms, for Graphviz's dot
"""
import collections
import pathlib
import re
import subprocess
import sys

source, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sees = {room: set(others) for room, *others in (line.split() for line in (build / "rooms.txt").read_text().splitlines())}


def reach(room, seen):
    for other in sees[room]:
        if other not in seen:
            seen.add(other)
            reach(other, seen)
    return seen


def room_of(path):
    """The innermost room that holds the file."""
    for folder in path.parents:
        if str(folder) in sees:
            return str(folder)
    return None


below = {room: reach(room, set()) for room in sees}
circles = [room for room in sees if room in below[room]]
includes = collections.Counter()
upward = []
for name in subprocess.check_output(["git", "ls-files", "*.cpp", "*.h"], cwd=source, text=True).split():
    room = room_of(pathlib.PurePath(name))
    if not room:
        continue
    for number, line in enumerate((source / name).read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include "([^"]+)"', line)
        if not found:
            continue
        target = pathlib.PurePath(found[1])
        other = room_of(target) if (source / target).is_file() else None
        if other and other != room:
            includes[room, other] += 1
            if other not in below[room]:
                upward.append(f"{name}:{number}: {room} does not see {other}")



def symbols(room, kind):
    """Of the room's library: those that it defines, or that it needs."""
    for folder in (build / room, *(build / room).parents):
        library = folder / f"libsymreal_{room.replace('/', '_')}.a"
        if library.exists():
            text = subprocess.check_output(["nm", "-g", f"--{kind}-only", library], text=True)
            return {line.split()[-1] for line in text.splitlines() if len(line.split()) > 1 and " V " not in line}
    return set()


defined = {room: symbols(room, "defined") for room in sees}
for room in sees:
    missing = symbols(room, "undefined") - defined[room]
    for other in sees:
        if other != room and other not in below[room]:
            for symbol in sorted(missing & defined[other]):
                if not any(symbol in defined[seen] for seen in below[room]):
                    upward.append(f"{room} does not see {other}, and needs its {symbol}")

if "--draw" in sys.argv:
    print("digraph rooms {\n  rankdir=BT;\n  node [shape=box];")
    for (room, other), count in sorted(includes.items()):
        print(f'  "{room}" -> "{other}" [label={count}];')
    print("}")
else:
    print("\n".join(upward + [f"{room}: sees itself" for room in circles]))
    print(f"{len(sees)} rooms, {sum(includes.values())} includes between them, {len(upward)} upward")
    sys.exit(1 if upward or circles or not includes else 0)
