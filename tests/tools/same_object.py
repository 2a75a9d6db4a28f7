"""Numeric mode is the original: same_object.py [--all] REWRITE INCLUDE SOURCE... [-- FLAG...]

Rewrites the sources, compiles each before and after with the same flags and compares the object files byte by byte,
symbol and debugging tables aside: at -O2, with --all at -O0 as well. With --all the rewritten source must also compile in
symbolic mode.
"""
import os
import subprocess
import sys
import tempfile


def run(*words, **options):
    done = subprocess.run(words, capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    everything = sys.argv[1] == "--all"
    rewrite, include, *rest = sys.argv[1 + everything :]
    sources, flags = (rest[: rest.index("--")], rest[rest.index("--") + 1 :]) if "--" in rest else (rest, [])
    with tempfile.TemporaryDirectory() as directory:
        mirror = run(rewrite, "--out-root", os.path.join(directory, "mirror"), *sources, "--", *flags).splitlines()
        header = ["-include", os.path.join(include, "symreal", "real.h")]
        for source in sources:
            rewritten = next(path for path in mirror if os.path.basename(path) == os.path.basename(source))
            compiler = "gcc" if source.endswith(".c") else "g++"
            for level in ("-O0", "-O2") if everything else ("-O2",):
                objects = [os.path.join(directory, name) for name in ("before.o", "after.o")]
                common = [compiler, "-w", level, *flags, "-c"]
                run(*common, source, "-o", objects[0])
                run(*common, *header, rewritten, "-o", objects[1])
                run("strip", "--strip-unneeded", *objects)
                before, after = (open(path, "rb").read() for path in objects)
                if before != after:
                    sys.exit(f"{source}: object code differs at {level}")
            if not everything:
                continue
            language = ["-DSYMREAL_SOURCE_OF_C"] if rewritten.endswith(".c") else []
            run("g++", "-w", "-DMBD_SYMBOLIC", *language, *flags, "-std=c++20", "-I", include, *header, "-x", "c++", "-fsyntax-only", rewritten)


main()
