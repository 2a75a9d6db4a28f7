"""`symreal oracle` on the kernels of a batch: it must give the same graph, where it takes the kernel."""
import json
from collections import Counter

from .messages import calls_as_errors
from .outcome import Found


def run_oracle(session, kernels, *words):
    """What it says, and where the kernels' texts stand."""
    places = session.write(kernels)
    return session.symreal_run("oracle", f"--decisions={session.policy}", f"--fp={session.mode}", f"--samples={session.samples}",
                               "--min-samples=1", "--json", *words), places


def record_twice(session, kernels, outcome):
    while kernels:
        done, places = run_oracle(session, kernels)
        if done.returncode in (0, 3):
            break
        named = session.refusals(calls_as_errors(done.stderr), places)
        if not named:
            outcome.found.append(Found(kernels[0], "oracle fails", done.stderr[-3000:], session.directory))
            return
        outcome.not_twice += Counter(ids[0] for ids in named.values())
        kernels = [k for k in kernels if k.name not in named]
    else:
        return
    for kernel, told in zip(kernels, json.loads(done.stdout)["kernels"]):
        if told["different"] != 0:
            # Compilers evaluate sinh(12) themselves, and not to the same last bit: then clang makes both.
            if run_oracle(session, [kernel], "--cxx=clang++-19")[0].returncode == 0:
                outcome.not_twice["compilers differ"] += 1
            else:
                outcome.found.append(Found(kernel, "the oracle gives another graph", json.dumps(told), session.directory))
        elif told["samples"] != 0:
            outcome.recorded_twice += 1
        else:
            outcome.not_twice["no sample"] += 1
