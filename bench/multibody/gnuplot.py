"""The study's own plots."""
import subprocess
import sys

COLOURS = {"fk": "#3b6ea5", "ik": "#8a6bb1", "rnea": "#3f8f5f", "crba": "#c98a3d", "aba": "#b5453b"}


def draw(path, commands, curves, size="760,420"):
    """An SVG or PNG. curves: (title, style, rows); the same figures give the same bytes."""
    terminal = "pngcairo" if str(path).endswith(".png") else "svg"
    blocks, plots = [], []
    for number, (title, style, rows) in enumerate(curves):
        blocks.append(f"$curve{number} << END\n" + "\n".join(" ".join(f"{value:.6g}" for value in row) for row in rows) + "\nEND\n")
        plots.append(f"$curve{number} {style} title '{title}'")
    script = (f"set terminal {terminal} size {size} font 'sans-serif,12' background rgb 'white'\nset output '{path}'\nset grid lc rgb '#cccccc'\n"
              "set key outside right top\n" + "".join(blocks) + commands + "\nplot " + ", \\\n  ".join(plots) + "\n")
    done = subprocess.run(["gnuplot"], input=script, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"study: gnuplot: {done.stderr}")


def best(member):
    """The generated contender that gcc optimised most."""
    return next(name for name in ("generated -O3", "generated -O1") if name in member["speedup"])


def is_arithmetic(member):
    """Whether + - * / take most of the time, not sines and cosines."""
    return member["kernel"] in ("rnea", "crba", "aba") and member["operations"]["compute"]["arithmetic"] > 200


def draw_all(members, docs, caches):
    chain = [member for member in members if member["shape"] == "spatial"]
    kernels = [kernel for kernel in COLOURS if any(member["kernel"] == kernel for member in chain)]

    def rows(kernel, values):
        return [(member["n"], *values(member)) for member in chain if member["kernel"] == kernel]

    def ratio(member):
        found = member["speedup"][best(member)]
        return found["quickest"], min(found["low"], found["quickest"]), max(found["high"], found["quickest"])

    draw(docs / "multibody-study-speed.svg",
         "set logscale xy\nset xlabel 'bodies of the spatial chain'\nset ylabel 'times as fast as the original'\n"
         "set yrange [0.3:10]\nset ytics (0.3, 0.5, 0.7, 1, 1.5, 2, 3, 5, 10)\nset arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb 'black'",
         [(kernel, f"using 1:2:3:4 with yerrorlines pt 7 ps 0.5 lw 1.5 lc rgb '{COLOURS[kernel]}'", rows(kernel, ratio)) for kernel in kernels])

    draw(docs / "multibody-study-operations.svg",
         "set logscale xy\nset xlabel 'bodies of the spatial chain'\nset ylabel '+ - * / in a call'\nset format y '10^{%T}'",
         [(f"{kernel}, {stage}", f"using 1:2 with linespoints pt 7 ps 0.4 lw 1.5 dt {dash} lc rgb '{COLOURS[kernel]}'",
           rows(kernel, lambda member, key=key: (max(1, member["operations"][key]["arithmetic"]),)))
          for kernel in kernels for stage, key, dash in (("original", "executed", 2), ("generated", "compute", 1))])

    def cost(kernel):
        of_kernel = sorted((member for member in members if member["kernel"] == kernel and is_arithmetic(member)), key=lambda member: member["text"][best(member)])
        return [(member["text"][best(member)] / 1024, member["nanoseconds"][best(member)]["quickest"] / operations(member)) for member in of_kernel]

    def operations(member):
        return member["operations"]["compute"]["arithmetic"]

    lines = "".join(f"set arrow from {size}, graph 0 to {size}, graph 1 nohead dt 3 lc rgb 'black'\n"
                    f"set label '{name}' at {size}, graph 0.95 offset 0.5,0\n" for name, size in caches.items())
    draw(docs / "multibody-study-cache.svg",
         "set logscale x\nset xlabel 'machine code in KB'\nset ylabel 'nanoseconds per operation of generated code'\nset yrange [0:*]\n" + lines,
         [(kernel, f"using 1:2 with points pt 7 ps 0.6 lc rgb '{COLOURS[kernel]}'", cost(kernel)) for kernel in ("rnea", "crba", "aba")])
