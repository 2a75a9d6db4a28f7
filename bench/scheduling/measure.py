"""Runs `symreal schedule` on graphs of many sizes and widths: run says how."""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import graphs

SIZES = [50, 100, 300, 500, 1000, 2500, 5000]
UNITS = [2, 4, 8, 16]
WIDTHS = [1, 1.5, 2, 3]  # of the graph, by unit: at about 1.5 work and longest path ask for the same length, which is hardest
LONGEST = {1: 10, 1.5: 100, 2: 10, 3: 100}  # durations, so that both occur
RESULTS = pathlib.Path(__file__).with_name("results.md")


def solve(path, units, *options):
    begin = time.monotonic()
    out = subprocess.run([os.environ["SYMREAL"], "schedule", path, "--units", str(units), "--json", *options],
                         check=True, capture_output=True, text=True).stdout
    result = json.loads(out)
    return {"gap": result["gap_percent"], "optimal": result["proven_optimal"], "seconds": time.monotonic() - begin}


def runs(sizes, directory):
    for size in sizes:
        for way in graphs.WAYS:
            for units in UNITS:
                for width in WIDTHS:
                    path = pathlib.Path(directory) / f"{way}-{size}-{units}-{width}.stg"
                    path.write_text(graphs.task_graph(way, size, round(width * units), LONGEST[width]))
                    yield {"size": size, "way": way.replace("_", " "), "units": units, "width": width, **solve(path, units)}
                    path.unlink()


def row(name, found):
    gaps, seconds = [r["gap"] for r in found], [r["seconds"] for r in found]
    optimal = sum(r["optimal"] for r in found)
    return (f"| {name} | {len(found)} | {optimal} | {statistics.mean(gaps):.3f} % | {statistics.quantiles(gaps, n=10)[-1]:.2f} % | "
            f"{max(gaps):.2f} % | {statistics.median(seconds):.2f} s | {max(seconds):.2f} s |")


def table(found, key, title):
    lines = [f"| {title} | Runs | Proven optimal | Mean gap | 9 of 10 below | Worst gap | Median time | Longest time |",
             "|---|---:|---:|---:|---:|---:|---:|---:|"]
    for value in dict.fromkeys(r[key] for r in found):
        lines.append(row(value, [r for r in found if r[key] == value]))
    lines.append(row("all", found))
    return "\n".join(lines)


def main():
    sizes = [int(word) for word in sys.argv[1:]]
    found = []
    with tempfile.TemporaryDirectory() as directory:
        for result in runs(sizes or SIZES, directory):
            found.append(result)
            print(f"{result['size']:6} {result['way']:22} {result['units']:3} units {result['width']:4} {result['gap']:6.2f} %  {result['seconds']:6.2f} s",
                  file=sys.stderr)
    page = f"""# Schedules beside their lower bounds

Written by bench/scheduling/run: `symreal schedule` at its usual effort on graphs of [four kinds](graphs.py), for {', '.join(map(str, UNITS))} units,
whose layers have {', '.join(map(str, WIDTHS))} tasks per unit. The gap is how much longer the timetable is than the best lower bound; a timetable without
gap is a shortest one. Times are those of the whole command, on a machine that others used as well.

{table(found, 'size', 'Tasks')}

{table(found, 'units', 'Units')}

{table(found, 'width', 'Width per unit')}

{table(found, 'way', 'Dependencies')}
"""
    print(page) if sizes else RESULTS.write_text(page)


main()
