"""The study's figures as tables."""
import csv

from families import KERNELS
from gnuplot import best

SELECTED = {"humanoid": [30], "planar": [2, 8, 64], "binary": [7, 63], "spatial": [2, 8, 32, 64, 128, 256, 1000]}


def count(entry):
    return f"{entry['arithmetic']} + {entry['calls']}" if entry["calls"] else str(entry["arithmetic"])


def duration(nanoseconds):
    for unit, size in (("ns", 1e3), ("µs", 1e6), ("ms", 1e9)):
        if nanoseconds < size:
            return f"{nanoseconds / (size / 1e3):.3g} {unit}"
    return f"{nanoseconds / 1e9:.3g} s"


def spread(ratio):
    return f"{ratio.get('quickest', ratio['median']):.2f} ({ratio['low']:.2f}-{ratio['high']:.2f})"


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|---" + "|---:" * (len(heading) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def time_of(member, name):
    return duration(member["nanoseconds"][name]["quickest"]) if name in member["nanoseconds"] else ""


def speedup(member, name):
    return spread(member["speedup"][name]) if name in member["speedup"] else ""


def family_table(members, shape):
    chosen = {}
    for kernel in KERNELS:
        of_kernel = [member for member in members if (member["kernel"], member["shape"]) == (kernel, shape)]
        chosen[kernel] = [member for member in of_kernel if member["n"] in SELECTED[shape] or member is of_kernel[-1]]
    rows = []
    for kernel, some in chosen.items():
        for member in some:
            large = best(member) == "generated -O1"
            rows.append([kernel, member["n"], count(member["operations"]["executed"]), count(member["operations"]["compute"]),
                         f"{member['text'][best(member)] / 1024:.3g}", f"{member['record']:.2f}", f"{member['emit']:.2f}",
                         f"{member['compile'][best(member)]:.1f}", time_of(member, "original -O2"), time_of(member, "original -O3"),
                         time_of(member, "generated -O2"), time_of(member, best(member)) + ("*" if large else ""),
                         speedup(member, "generated -O2"), speedup(member, best(member)) + ("*" if large else "")])
    return table(["Kernel", "N", "Operations before", "after", "Code, KB", "Record, s", "Optimise and emit, s", "Compile, s", "Original -O2",
                  "-O3", "Generated -O2", "-O3", "Times as fast, -O2", "-O3"], rows)


def term(coefficient, power):
    factor = "" if power and abs(coefficient) == 1 else f"{abs(coefficient):.6g}"
    return " ".join(filter(None, [factor, ["", "N", "N²", "N³", "N⁴", "N⁵", "N⁶"][power]]))


def law(figure):
    """The exact polynomial, or the one that is close; with its residual the power where neither is."""
    polynomial = figure["polynomial"]
    text = ""
    for power in reversed(range(len(polynomial["coefficients"]))):
        coefficient = polynomial["coefficients"][power]
        if coefficient:
            text += (" - " if coefficient < 0 else " + " if text else "") + term(coefficient, power)
    if polynomial["exact"]:
        first = polynomial["from"]
        return text.strip() + (f" from N = {first:.0f} on" if first > 2 else "")
    if polynomial["residual"] < 0.03 and len(polynomial["coefficients"]) < 4:
        return f"about {text.strip()} ({100 * polynomial['residual']:.1f} %)"
    power = figure["power"]
    return f"about {power['factor']:.3g} N^{power['exponent']:.2f} ({100 * power['residual']:.0f} %)"


def growth_table(growth):
    rows = []
    for name, family in growth.items():
        kernel, shape = name.split()
        last = family["members"][-1]
        rows.append([kernel, shape, law(family["growth"]["arithmetic"]), law(family["growth"]["span"]), f"{last['parallelism']:.3g}"])
    return table(["Kernel", "Family", "+ - * / after", "Span", "Mean parallelism at N = 64"], rows)


def simulation_table(models):
    rows = []
    for model in models:
        times = model["nanoseconds"]
        rows.append([model["title"], model["states"], f"{model['steps']} of {model['step']:g} s", count(model["operations"]["executed"]),
                     count(model["operations"]["compute"]), duration(times["original -O3"]["quickest"]),
                     duration(times["generated -O3"]["quickest"]), spread(model["speedup"]["generated -O2"]),
                     spread(model["speedup"]["generated -O3"])])
    return table(["Model", "States", "Steps", "Operations before", "after", "A step: original -O3", "generated -O3", "Times as fast, -O2",
                  "-O3"], rows)


def write_csv(members, path):
    names = ["original -O2", "original -O3", "generated -O2", "generated -O3", "generated -O1"]
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["kernel", "family", "bodies", "outputs", "operations before", "calls before", "operations after", "calls after",
                         "work", "span", "parallelism", "least units", "record s", "optimise and emit s",
                         *(f"compile {name[10:]} s" for name in names[2:]), *(f"text {name[10:]} bytes" for name in names[2:]),
                         *(f"{name} ns{part}" for name in names for part in ("", " low", " median", " high"))])
        for member in members:
            before, after = member["operations"]["executed"], member["operations"]["compute"]
            times = [f"{member['nanoseconds'][name][part]:.1f}" if name in member["nanoseconds"] else ""
                     for name in names for part in ("quickest", "low", "median", "high")]
            writer.writerow([member["kernel"], member["shape"], member["n"], member["outputs"], before["arithmetic"], before["calls"],
                             after["arithmetic"], after["calls"], member["work"], member["span"], f"{member['parallelism']:.2f}",
                             member["least_units"], f"{member['record']:.3f}", f"{member['emit']:.3f}",
                             *(f"{member['compile'][name]:.2f}" if name in member["compile"] else "" for name in names[2:]),
                             *(member["text"].get(name, "") for name in names[2:]), *times])
