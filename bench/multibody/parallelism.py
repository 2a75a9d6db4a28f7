"""The analysis of the families' graphs: their plots, and the largest graph of all."""
import json

import families
import measure
from contenders import timed

# The plots of the page.
DRAWN = {"aba_spatial_8": ("aba", "spatial", 8), "crba_binary_31": ("crba", "binary", 31), "rnea_humanoid": ("rnea", "humanoid", 30)}
LARGEST = ("crba", "spatial", 1000)


def draw(docs, top):
    """The three plots of each, and the figures beside them."""
    figures = {}
    for name, (kernel, shape, n) in DRAWN.items():
        work = top / name
        work.mkdir(parents=True, exist_ok=True)
        families.generate(kernel, shape, n, work)
        measure.command([measure.SYMREAL, "plot", work / "graph", "--passes=default", "-o", docs / f"multibody-study-{name}.svg"])
        figures[name] = {"kernel": kernel, "shape": shape, "n": n, **json.loads(
            measure.command([measure.SYMREAL, "analyze", work / "graph", "--passes=default", "--json"]))}
        figures[name].pop("critical_path")
    return figures


def largest(top):
    kernel, shape, n = LARGEST
    work = top / "largest"
    work.mkdir(parents=True, exist_ok=True)
    recorded, optimised = work / "graph", work / "optimised.graph"
    text, cost = timed([measure.SYMREAL, "generate", *families.command_line(kernel, [shape, n]), "--timeout", "1200", "-o",
                        work / "kernel.c", "--graph", recorded, "--json", "--", *families.FLAGS])
    report = json.loads(text)["kernels"][0]
    result = {"kernel": kernel, "shape": shape, "n": n, "generate": {**cost, **report["seconds"]}, "code": (work / "kernel.c").stat().st_size,
              "operations": {stage: measure.counts(report["operations"][stage]) for stage in ("executed", "recorded", "compute")}}
    (work / "kernel.c").unlink()
    measure.command([measure.SYMREAL, "opt", recorded, "--lang=graph", "-o", optimised])
    for stage, graph in (("recorded", recorded), ("optimised", optimised)):
        text, cost = timed([measure.SYMREAL, "analyze", graph, "--json"])
        analysis = json.loads(text)
        result[stage] = {**cost, **{key: analysis[key] for key in ("operations", "work", "span", "parallelism", "peak")}}
        graph.unlink()
    return result
