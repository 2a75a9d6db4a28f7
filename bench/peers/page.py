"""bench/peers/benchmarks.md with its plots and CSV, bench/peers/results.md and the README's table, from what was measured."""
import pathlib
import subprocess
import sys

import contenders
import figures
import generate
import goals
import tables

sys.path += ["bench", "bench/multibody"]
from gnuplot import draw  # noqa: E402
from hardware import processor  # noqa: E402

HERE = contenders.HERE
GENERATORS = [*contenders.MODES, *contenders.PYTHON, "CppADCodeGen"]
SHOWN = ["original", *contenders.PEERS, *contenders.MODES, *contenders.FURTHER]
COLOURS = dict(zip(SHOWN, ["#000000", "#8a6bb1", "#3b6ea5", "#3f8f5f", "#7f8c3f", "#2aa1a1", "#999999", "#e3a29b", "#c98a3d", "#b5453b", "#2aa1a1",
                           "#e377c2", "#8c564b", "#d62728"]))
DASHED = contenders.FURTHER


def machine():
    versions = [subprocess.run([name, "--version"], capture_output=True, text=True).stdout.splitlines()[0] for name in ("gcc", "clang-19")]
    return {"cpu": processor(), "compilers": versions, "versions": contenders.installed()}


def summary(data):
    """A line for the terminal."""
    row = figures.Row({"kernel": "fk", "joints": 0, "contenders": data})
    own, best = figures.ours(row), figures.peer(row)
    if not own:
        return "no code of Symreal: " + row.missing("Symreal finite")
    said = f"{own} {row.median(own):.0f} ns"
    if best:
        said += f", {goals.spread(row.ratio(best, own))} times as fast as {best}"
    return said + f", {goals.spread(row.ratio('original', own, figures.ORIGINAL))} as the original at {figures.ORIGINAL}"


def curves(rows, kernel, names, value, spread=None):
    found = []
    for name in names:
        points = [(row.joints, *([value(row, name)] if spread is None else spread(row, name))) for row in rows
                  if row.kernel == kernel and name in row.contenders and value(row, name) is not None]
        if points:
            style = "using 1:2 with linespoints" if spread is None else "using 1:2:3:4 with yerrorlines"
            found.append((name, f"{style} pt 7 ps 0.5 lw 1.5 dt {2 if name in DASHED else 1} lc rgb '{COLOURS[name]}'", points))
    return found


def draw_all(rows):
    def median(row, name):
        return row.median(name) / row.joints if row.there(name) else None

    def with_spread(row, name):
        time = row.time(name)
        return [time[part] / row.joints for part in ("median", "low", "high")]

    def compile_time(row, name):
        return row.variant(name)["compile"] if row.there(name) else None

    def error(row, name):
        return (row.variant(name)["error"] or None) if row.there(name) else None

    plots = {"compile": ("seconds of a processor to compile", compile_time, [*GENERATORS, *contenders.LOOPED], None),
             "error": ("largest error, relative to the largest output", error, [name for name in SHOWN if name != "Pinocchio"], None),
             "record": ("million operations recorded in a second", tables.rate_of("record", None), GENERATORS, None),
             "write": ("million operations optimised and written in a second", tables.rate_of("write", None), GENERATORS, None)}
    for kernel in generate.KERNELS:
        for ending in ("svg", "png"):
            draw(HERE / f"benchmarks-{kernel}.{ending}", "set logscale xy\nset xlabel 'joints'\nset ylabel 'nanoseconds per call and joint'",
                 curves(rows, kernel, SHOWN, median, with_spread), "860,480")
    for name, (title, value, names, spread) in plots.items():
        for ending in ("svg", "png"):
            draw(HERE / f"benchmarks-{name}.{ending}", f"set logscale xy\nset format y '%g'\nset xlabel 'joints, forward dynamics'\nset ylabel '{title}'",
                 curves(rows, "aba", names, value, spread), "860,480")


def six_table(rows, versions):
    """Operations at six joints, as the README and results.md have them."""
    peers = [*contenders.PYTHON, "CppADCodeGen"]
    lines = []
    for row in (row for row in rows if row.joints == 6):
        executed = row.contenders["Symreal finite"]["executed"]
        lines.append("| " + " | ".join(map(str, [figures.TITLES[row.kernel], executed, row.operations("Symreal finite"), row.operations("Symreal fast"),
                                                 *(row.operations(name) or row.missing(name) for name in peers)])) + " |")
    heading = ["Six-joint chain", "Original", "Symreal `finite`", "Symreal `fast`", *(f"{name} {versions.get(name, '')}".strip() for name in peers)]
    return "\n".join(["| " + " | ".join(heading) + " |", "|---" * len(heading) + "|", *lines])


def put_between(path, begin, end, text):
    whole = path.read_text()
    if begin not in whole or end not in whole:
        raise SystemExit(f"bench: {path} has no place for the table: {begin}")
    before, rest = whole.split(begin, 1)
    path.write_text(before + begin + "\n" + text + "\n" + end + rest.split(end, 1)[1])


def more_operations(rows):
    more, count = goals.operations(rows)
    if not more:
        return "On no row does a peer that reads the same source leave fewer operations than mode `finite`."
    lines = []
    for row, own, fewer in more:
        differences = [row.difference(name) for name in fewer]
        known = [difference for difference in differences if difference is not None]
        least = "not compared" if len(known) < len(differences) else f"{min(known):.1e}"
        lines.append([row.title, own, row.operations(fewer[0]), ", ".join(fewer), least])
    said = tables.table(["Row", "`finite`", "fewest by a peer", "peers with fewer", "their results differ from the original's by at least"], lines)
    return (f"In {len(more)} of {count} rows a peer leaves fewer operations than mode `finite`. The last column is the least of these peers' largest\n"
            "differences, relative to the largest output, where no operations are fused: what is not 0 is what mode `finite` may not do.\n\n" + said)


def lost(rows):
    lines = goals.losses(rows)
    none = [f"{row.title} ({row.missing('Symreal finite')})" for row in rows if row.there("original") and not figures.ours(row)]
    said = f"\n\nRows without code of Symreal, which count nowhere: {'; '.join(none)}." if none else ""
    if not lines:
        return "There is no row in which Symreal is slower than the original at `gcc -O3 -march=native` or than the best peer." + said
    return "Rows in which Symreal is slower than the original or than the best peer:\n\n" + tables.table(
        ["Row", "Symreal's fastest", "the other", "ns", "ns of the other", "times as fast"], lines) + said


def from_careful(rows):
    lines = []
    for row in rows:
        ours, theirs = "careful source, Symreal fast", "careful source, CppADCodeGen"
        if row.there(ours) and row.there(theirs) and row.there("Symreal fast"):
            lines.append([row.title, row.operations(theirs), row.operations(ours), row.operations("Symreal fast"), f"{row.median(theirs):.4g}",
                          f"{row.median(ours):.4g}", f"{row.median('Symreal fast'):.4g}", goals.spread(row.ratio(theirs, ours))])
    return tables.table(["Row", "Operations: CppADCodeGen", "Symreal fast", "textbook, Symreal fast", "ns: CppADCodeGen", "Symreal fast",
                         "textbook, Symreal fast", "Symreal over CppADCodeGen"], lines)


def write(measured):
    rows = [figures.Row(row) for row in measured["rows"]]
    about = measured["machine"]
    draw_all(rows)
    tables.write_csv(rows, HERE / "benchmarks.csv")
    six = {row.kernel: row for row in rows if row.joints == 6}
    longest = max(row.joints for row in rows)
    values = {
        "cpu": about["cpu"], "compilers": " and ".join(about["compilers"]), "launches": measured["launches"], "rounds": measured["rounds"],
        "versions": ", ".join(f"{name} {version}" for name, version in about["versions"].items()), "longest": longest,
        "goals": tables.table(["Goal", "wanted", "measured", ""], goals.of_six(rows) + goals.everywhere(rows)),
        "lost": lost(rows), "more": more_operations(rows), "careful": from_careful(rows), "large": contenders.LARGE, "long": contenders.LONG, "loops": contenders.LOOPS,
        "compile_limit": contenders.COMPILE_SECONDS, "generate_limit": contenders.GENERATE_SECONDS,
        "lines": len((HERE / "chain.py").read_text().splitlines()), "careful_lines": len((HERE / "careful.cpp").read_text().splitlines()),
        **{f"six_{kernel}": tables.six(row) for kernel, row in six.items()},
        **{f"times_{kernel}": tables.growth(rows, kernel, SHOWN, tables.time_of) for kernel in generate.KERNELS},
        **{f"counts_{kernel}": tables.growth(rows, kernel, [*GENERATORS, *contenders.FURTHER], tables.count_of) for kernel in generate.KERNELS},
        "compile": tables.growth(rows, "aba", [*GENERATORS, *contenders.LOOPED], tables.compile_of),
        "error": tables.growth(rows, "aba", SHOWN, tables.error_of),
        "record": tables.growth(rows, "aba", GENERATORS, tables.as_text(tables.rate_of("record", None))),
        "write": tables.growth(rows, "aba", GENERATORS, tables.as_text(tables.rate_of("write", None))),
    }
    for template, target in ((HERE / "page.template", HERE / "benchmarks.md"), (HERE / "results.template", HERE / "results.md")):
        text = template.read_text()
        for key, value in {**values, "six": six_table(rows, about["versions"])}.items():
            text = text.replace("{{" + key + "}}", str(value))
        if "{{" in text:
            raise SystemExit(f"bench: {template} asks for what was not measured: {text[text.index('{{'):][:40]}")
        target.write_text(text)
    put_between(pathlib.Path("README.md"), "<!-- operations: written by bench/peers/run -->", "<!-- end of operations -->", six_table(rows, about["versions"]))
