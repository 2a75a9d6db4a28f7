"""The large-scale study: see bench/study.

   families     generate ──▶ compile ──▶ equal outputs ──▶ times in turns; parallelism; growth
   simulations  trajectories by original and generated code, equal to the last bit
   largest      the analysis of 14 million operations
"""
import json
import pathlib
import shutil
import sys

import families
import measure
import simulations

WORK = pathlib.Path("build/study")


def run_families():
    results = families.measure_families(families.SHAPES, WORK, rounds=21)
    growth = {f"{kernel} {shape}": families.growth(kernel, shape)
              for shape in ("planar", "spatial", "binary") for kernel in families.KERNELS}
    return {"members": results, "growth": growth, "machine": measure.machine()}


def run_simulations():
    return {"models": simulations.measure_simulations(simulations.SIMULATED, WORK, rounds=9), "machine": measure.machine()}


def small():
    families.measure_families(families.SMALL, WORK / "small", rounds=3)
    simulations.measure_simulations(["slider_crank"], WORK / "small", rounds=1)


PARTS = {"families": run_families, "simulations": run_simulations}


def main():
    wanted = sys.argv[1:] or list(PARTS)
    if wanted == ["--small"]:
        return small()
    if wanted == ["--page"]:
        wanted = []
    if unknown := [part for part in wanted if part not in PARTS]:
        sys.exit(f"study: there is no part {unknown[0]}; there are {', '.join(PARTS)}")
    WORK.mkdir(parents=True, exist_ok=True)
    for part in wanted:
        (WORK / f"{part}.json").write_text(json.dumps(PARTS[part](), indent=1))


main()
