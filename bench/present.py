"""The measurements as text and as a picture."""
import pathlib
import re

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "symreal"  # the same figures give the same bytes
matplotlib.rcParams["svg.fonttype"] = "none"  # text stays text
import matplotlib.pyplot as plot  # noqa: E402


def spread(ratio, digits=2):
    return f"{ratio['median']:.{digits}f} ({ratio['low']:.{digits}f}-{ratio['high']:.{digits}f})"


def count(entry):
    return f"{entry['arithmetic']} + {entry['calls']}" if entry["calls"] else str(entry["arithmetic"])


def speedup_table(results):
    lines = ["| Program | Operations before | after | in preprocess "
             "| Speed-up at -O2 | at -O3 -march=native | ... with fma |",
             "|---|---|---|---|---|---|---|"]
    for result in results:
        operations, ratios = result["operations"], result["ratios"]
        lines.append(f"| {result['kernel']} | {count(operations['executed'])} | {count(operations['compute'])} "
                     f"| {count(operations['preprocess'])} | {spread(ratios['-O2'])} | {spread(ratios['-O3'])} "
                     f"| {spread(ratios['-O3 fma'])} |")
    return "\n".join(lines) + "\n"


def time_table(results):
    names = list(results[0]["nanoseconds"])
    lines = ["| Program | " + " | ".join(names) + " | Largest difference |", "|---" * (len(names) + 2) + "|"]
    for result in results:
        cells = [spread(result["nanoseconds"][name], 0) for name in names]
        lines.append(f"| {result['kernel']} | " + " | ".join(cells) + f" | {result['difference']:.0e} |")
    return "\n".join(lines) + "\n"


def write_text(results, machine):
    pathlib.Path("bench/results.md").write_text(f"""# Original against generated code

Written by `bench/run` on {machine['cpu']} with {machine['compiler']}.

![speed-ups](results.svg)

**Operations** are those that the original executes in one call of the kernel and those that `compute` executes: + - * /,
and, after the plus sign, square roots and calls of the mathematical library. Sign changes are not counted. `preprocess`
runs once for a set of parameters.

**Speed-up** is the time of the original divided by the time of `compute`, both compiled by gcc with the flags in the
heading. Without contraction, which the numerical promise of mode `finite` wants, in the first two columns; in the
last one gcc may contract to fused multiply-adds on both sides, as it does by default under -march=native (the original is
always compiled with gcc's default). The figure is the median of {machine['rounds']} rounds in which all contenders run
one after the other in blocks of {machine['block']} of processor time; in parentheses the interquartile range.

What an original does besides arithmetic is in its time: the `_parameters` variants of `chain` build the model anew in
every call, the libraries allocate vectors. In `rotation` the compiler sees the constant matrix as well, and at -O3 it
unrolls the loops and finds what Symreal finds.

{speedup_table(results)}
Time per call in nanoseconds, median and interquartile range. The inputs change from call to call; copying them is part
of every figure. The last column is the largest difference between outputs of any two contenders, relative to the larger
of 1 and the value: contraction and vectorisation by the compiler, none of it Symreal's (`symreal verify` compares with
the reference build).

{time_table(results)}""")


def recorded_ratios():
    """The speed-ups that bench/results.md has, as measure() gives them."""
    results = []
    for line in pathlib.Path("bench/results.md").read_text().splitlines():
        spreads = re.findall(r"([\d.]+) \(([\d.]+)-([\d.]+)\)", line)
        if len(spreads) == 3:  # the other table has five
            ratios = [dict(zip(("median", "low", "high"), map(float, spread))) for spread in spreads]
            results.append({"kernel": line.split("|")[1].strip(), "ratios": dict(zip(("-O2", "-O3", "-O3 fma"), ratios))})
    return results


def write_plot(results):
    colours = {"-O2": "#8aa9c9", "-O3": "#2f5d8c", "-O3 fma": "#c98a3d"}
    titles = {"-O2": "-O2", "-O3": "-O3 -march=native", "-O3 fma": "-O3 -march=native, contraction allowed"}
    figure, axes = plot.subplots(figsize=(8, 0.3 * len(results) + 1.2))
    height = 0.8 / len(titles)
    for number, title in enumerate(titles):
        ratios = [result["ratios"][title] for result in results]
        medians = [ratio["median"] for ratio in ratios]
        axes.barh([place + (number - 1) * height for place in range(len(results))], medians, height,
                  xerr=[[ratio["median"] - ratio["low"] for ratio in ratios],
                        [ratio["high"] - ratio["median"] for ratio in ratios]],
                  color=colours[title], label=titles[title], error_kw={"elinewidth": 0.8})
    axes.axvline(1, color="black", linewidth=0.8)
    axes.set_xscale("log")
    ticks = [1, 2, 3, 5, 10, 20]
    axes.set_xticks(ticks, [f"{tick}x" for tick in ticks])
    axes.minorticks_off()
    axes.grid(axis="x", linewidth=0.4, color="#bbbbbb")
    axes.set_axisbelow(True)
    axes.set_ylim(len(results) - 0.4, -0.6)
    axes.set_yticks(range(len(results)), [result["kernel"] for result in results])
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel("how many times faster the generated code is than the original")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3, fontsize="small", frameon=False)
    figure.tight_layout()
    figure.savefig("bench/results.svg", metadata={"Date": None})


def write_results(results, machine):
    write_text(results, machine)
    write_plot(results)
