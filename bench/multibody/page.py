"""bench/multibody/multibody-study.md, from what was measured."""
import pathlib
import subprocess

import gnuplot
import tables
from families import BOTH, COMPILED, KERNELS

HERE = pathlib.Path(__file__).resolve().parent


def cache_sizes():
    sizes = {}
    for name, key in (("L1i", "LEVEL1_ICACHE_SIZE"), ("L2", "LEVEL2_CACHE_SIZE")):
        text = subprocess.run(["getconf", key], capture_output=True, text=True).stdout.strip()
        if text.isdigit() and int(text):
            sizes[name] = int(text) // 1024
    return sizes


def gain(member):
    return member["speedup"][gnuplot.best(member)]["quickest"]


def code_size(member):
    """In KB."""
    return member["text"][gnuplot.best(member)] / 1024


def between(values):
    low, high = f"{min(values):.1f}", f"{max(values):.1f}"
    return low if low == high else f"{low} to {high}"


def speeds(members):
    """A sentence for each family on what the generated code gains against -O3."""
    lines = []
    for shape in ("planar", "spatial", "binary", "humanoid"):
        of_shape = [member for member in members if member["shape"] == shape and member["n"] > 1]
        said = []
        for kernel in KERNELS:
            gains = [gain(member) for member in of_shape if member["kernel"] == kernel]
            said.append(between(gains) if gains else "")
        lines.append(f"| {shape} | " + " | ".join(said) + " |")
    return "| Family | " + " | ".join(KERNELS) + " |\n" + "|---" * (len(KERNELS) + 1) + "|\n" + "\n".join(lines) + "\n"


def gains_where(members, wanted):
    return between([gain(member) for member in members if wanted(member)] or [0])


def per_operation(members, fits):
    """Nanoseconds per operation of generated code whose size satisfies `fits`."""
    some = sorted(member["nanoseconds"][gnuplot.best(member)]["quickest"] / member["operations"]["compute"]["arithmetic"] for member in members
                  if gnuplot.is_arithmetic(member) and fits(code_size(member)))
    if not some:
        return "none was measured"
    return f"median {some[len(some) // 2]:.2f} ns ({some[0]:.2f} to {some[-1]:.2f}, {len(some)} members)"


def where_it_ends(members):
    """For each kernel and family: the first member that is not faster than the original at -O3, and the one before."""
    rows = []
    for kernel in KERNELS:
        for shape in ("planar", "spatial", "binary"):
            line = [member for member in members if (member["kernel"], member["shape"]) == (kernel, shape)]
            place = next((place for place, member in enumerate(line) if gain(member) <= 1), 0)
            if place:
                first = line[place]
                rows.append([kernel, shape, line[place - 1]["n"], first["n"], f"{code_size(first):.0f}",
                             tables.spread(first["speedup"][gnuplot.best(first)])])
    if not rows:
        return "No member that was compiled falls behind the original's loops at -O3.\n"
    return tables.table(["Kernel", "Family", "Last N that is faster", "First N that is not", "its code, KB", "times as fast"], rows)


def write(parts):
    families, machine = parts["families"], parts["families"]["machine"]
    members, growth = families["members"], families["growth"]
    models, largest, drawn = parts["simulations"]["models"], parts["largest"], parts["plots"]
    caches = cache_sizes()
    gnuplot.draw_all(members, HERE, caches)
    tables.write_csv(members, HERE / "multibody-study.csv")
    text = (pathlib.Path(__file__).parent / "page.template").read_text()
    level1, level2 = caches.get("L1i", 32), caches.get("L2", 512)
    andrews = next(model for model in models if model["name"] == "andrews")
    real = parts["real"]
    plots = "\n\n".join(
        f"![Operations at once](multibody-study-{name}.svg)\n\n*{KERNELS[figure['kernel']][0]}, {figure['shape']}, N = {figure['n']}*: "
        f"work {figure['work']}, span {figure['span']}, mean parallelism {figure['parallelism']:.1f}; at the peak {figure['peak']['from_inputs']} "
        f"operations at once from the inputs, {figure['peak']['from_outputs']} from the outputs, {figure['peak']['levelled']} levelled."
        for name, figure in drawn.items())
    values = {
        "cpu": machine["cpu"], "compiler": machine["compiler"], "caches": f"{level1} KB of first-level instruction cache and {level2} KB of second-level cache a core",
        "members": len(members), "outputs": sum(member["outputs"] for member in members), "others": f"{families['load']:.1f} other processes ran on average when it began", "both": BOTH, "compiled": COMPILED,
        "speeds": speeds(members), "growth": tables.growth_table(growth), "ends": where_it_ends(members),
        "in_level1": per_operation(members, lambda size: size <= level1),
        "in_level2": per_operation(members, lambda size: level1 < size <= level2),
        "beyond": per_operation(members, lambda size: size > level2),
        **{f"table_{shape}": tables.family_table(members, shape) for shape in ("humanoid", "planar", "binary", "spatial")},
        "simulations": tables.simulation_table(models), "models": len(models),
        "angle_digits": int(andrews["digits"][0]), "rate_digits": int(andrews["digits"][1]),
        "plots": plots, "executed": largest["operations"]["executed"]["arithmetic"], "recorded": largest["operations"]["recorded"]["arithmetic"],
        "after": largest["operations"]["compute"]["arithmetic"], "largest": largest_table(largest), "kdl_before": tables.count(real["operations"]["executed"]),
        "kdl_after": tables.count(real["operations"]["compute"]), "kdl_O2": tables.spread(real["ratios"]["-O2"]), "kdl_O3": tables.spread(real["ratios"]["-O3"]),
        "small_gain": gains_where(members, lambda member: member["n"] in (2, 3)), "middle_gain": gains_where(members, lambda member: 8 <= member["n"] < 32),
        "fits_gain": gains_where(members, lambda member: member["n"] > 31 and code_size(member) <= level2),
        "beyond_median": between([member["speedup"][gnuplot.best(member)]["median"] for member in members if code_size(member) > level2] or [0]),
        "beyond_gain": gains_where(members, lambda member: code_size(member) > level2),
        "compile_rate": f"{compile_rate(members):.0f}",
    }
    for key, value in values.items():
        text = text.replace("{{" + key + "}}", str(value).rstrip("\n"))
    if "{{" in text:
        raise SystemExit("study: page.template asks for what was not measured: " + text[text.index("{{"):][:40])
    (HERE / "multibody-study.md").write_text(text)


def compile_rate(members):
    """Operations that gcc compiles in a second, of members large enough."""
    rates = sorted(member["operations"]["compute"]["arithmetic"] / member["compile"][gnuplot.best(member)] for member in members
                   if member["operations"]["compute"]["arithmetic"] > 5000)
    return rates[len(rates) // 2] if rates else 0


def largest_table(largest):
    rows = []
    for stage in ("recorded", "optimised"):
        part = largest[stage]
        rows.append([stage, part["operations"], part["span"], f"{part['parallelism']:.0f}", f"{part['peak']['levelled']}",
                     f"{part['processor']:.0f} s", f"{part['clock']:.0f} s", f"{part['memory'] / 1e9:.2f} GB"])
    return tables.table(["Graph", "Operations", "Span", "Mean parallelism", "Peak, levelled", "Processor time of `analyze`", "On the clock",
                         "Most memory"], rows)
