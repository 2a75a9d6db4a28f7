#!/usr/bin/env python3
"""examples_in.py SYMREAL INPUTS DIR [--few | --only NAME,...] LANGUAGE...: generates every example program of INPUTS, or a few with
all that these have, or those of these names, in C and the languages, into DIR, runs each with its recorded inputs, and compares with C
as same_in.py does. What calls a library of its own is left out."""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
CHAIN = "chain/algorithms.cpp chain/example.cpp chain/model.cpp chain/spatial.cpp"
DH = "dh/dynamics.cpp dh/robot.cpp"
# Name: sources, options.
EXAMPLES = {
    "arm": ("arm_eigen/arm.cpp", "-- -I/usr/include/eigen3"),
    "charger": ("charger/charger.c", "--decisions=guard -- -DONE_PHASE"),
    "controller": ("controller/controller.c", "--decisions=select"),
    "inverse": (f"dh/rx90_inverse.cpp {DH}", ""),
    "mass": (f"dh/rx90_mass.cpp {DH}", ""),
    "hourglass": ("hexahedron/hexahedron.c", "--kernel hourglass_force"),
    "rate": ("hexahedron/hexahedron.c", "--kernel deformation_rate"),
    "kalman": ("kalman/kalman.cpp", ""),
    "tree": ("kdl_fk/kdl_fk.cpp", "--root=/usr/include/kdl"),
    "kepler": ("kepler/kepler.cpp", "--decisions=guard"),
    "bounded": ("kepler/kepler.cpp", "-- -DBOUNDED"),
    "decomposition": ("lu/lu.cpp", "--decisions=guard"),
    "oscillator": ("oscillator/oscillator.c", ""),
    "pendulum": ("pendulum_c89/pendulum.c", ""),
    "rotation": ("rotation/rotation.cpp", ""),
    "full": ("rotation/rotation_full.cpp", ""),
    "vehicle": ("vehicle/vehicle.cpp", "--decisions=select"),
    "aba": (f"chain/aba.cpp {CHAIN}", ""),
    "crba": (f"chain/crba_parameters.cpp {CHAIN}", ""),
    "fk": (f"chain/fk.cpp {CHAIN}", ""),
    "rnea": (f"chain/rnea_parameters.cpp {CHAIN}", ""),
}
# Together they have every operation and every kind of line of a graph that the others have.
FEW = ["arm", "charger", "controller", "rate", "kalman", "kepler", "decomposition", "oscillator", "pendulum", "rotation", "vehicle", "rnea"]


def main():
    symreal, inputs, directory, *languages = sys.argv[1:]
    failed, names = False, list(EXAMPLES)
    if languages[0] == "--few":
        names, languages = FEW, languages[1:]
    elif languages[0] == "--only":
        names, languages = languages[1].split(","), languages[2:]
    for name in names:
        sources, options = EXAMPLES[name]
        base = os.path.join(directory, f"the_{name}")  # no name that a language has
        before, _, behind = options.partition("-- ")
        subprocess.run([symreal, "generate", *(os.path.join(inputs, source) for source in sources.split()),
                        f"--lang={','.join(['c', *languages])}", "--mainline", "-o", base + ".c", *before.split(),
                        *(["--", behind] if behind else [])], check=True, stderr=subprocess.DEVNULL)
        for language in languages:
            done = subprocess.run([sys.executable, f"{HERE}/same_in.py", language, base, "--ulps",
                                   os.path.join(HERE, "..", "languages", "ulps.table")], capture_output=True, text=True)
            if done.returncode != 0:
                failed = True
                print(f"{name} in {language}:\n{done.stdout}{done.stderr}")
    print(f"{len(names)} examples in {', '.join(languages)}: {'not ' if failed else ''}as in C")
    sys.exit(failed)


if __name__ == "__main__":
    main()
