"""What families and simulations share: flags, building, equal outputs, times."""
import os
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor

import measure

# Of the original. The first is the reference that generated code must equal.
ORIGINALS = {
    "reference": ["-O2", "-ffp-contract=off", "-fno-builtin", "-fno-fast-math"],
    "original -O2": ["-O2"],
    "original -O3": ["-O3", "-march=native"],
}
UNCONTRACTED = ["-ffp-contract=off", "-fno-tree-slp-vectorize"]
GENERATED = {
    "generated -O2": ["-O2", *UNCONTRACTED],
    "generated -O3": ["-O3", "-march=native", *UNCONTRACTED],
}
# In place of both where they would take minutes.
LARGE = {"generated -O1": ["-O1", "-march=native", *UNCONTRACTED]}
# Which original a generated contender is compared with.
AGAINST = {"generated -O2": "original -O2", "generated -O3": "original -O3", "generated -O1": "original -O3"}


def compiler(source):
    return "gcc" if str(source).endswith(".c") else "g++"


def timed(words):
    """Standard output, and what the command took: seconds on the clock and of a processor, the most memory in bytes."""
    begin = time.perf_counter()
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, text=True)
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"study: {' '.join(map(str, words))} failed")
    return text, {"clock": time.perf_counter() - begin, "processor": usage.ru_utime + usage.ru_stime, "memory": usage.ru_maxrss * 1024}


def compile_all(jobs):
    """jobs: (source, target, flags); compiles two at a time, returns the processor time of each in seconds."""
    def one(job):
        source, target, flags = job
        return timed([compiler(source), "-c", "-w", source, "-o", target, *flags])[1]["processor"]
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(one, jobs))


def text_size(obj):
    return int(measure.command(["size", obj]).splitlines()[1].split()[0])


def start(executable):
    """A contender in front of what else the machine does, where that is allowed."""
    return measure.Contender("nice", "-n", "-5", executable)


def same(values, reference):
    return len(values) == len(reference) and all(a == b or (a != a and b != b) for a, b in zip(values, reference))


def spread(values, quickest):
    return {**measure.quartiles(values), "quickest": quickest}


def gains(times):
    """How many times as fast generated contenders are: in the quickest turns, and turn by turn."""
    return {name: spread([a / b for a, b in zip(times[AGAINST[name]], times[name])], min(times[AGAINST[name]]) / min(times[name]))
            for name in times if name.startswith("generated")}


def check_and_time(executables, rounds, launches=3, block=0.001):
    """Every generated contender must have the reference's outputs; then the others are timed in turns. Each is launched several
    times, because it matters for its speed where its pages happen to lie, and is warm when the clock starts."""
    times = {name: [] for name in executables if name != "reference"}
    for launch in range(launches):
        running = {name: start(path) for name, path in executables.items() if launch == 0 or name in times}
        try:
            if launch == 0:
                reference = running["reference"].values()
                for name, contender in running.items():
                    if name.startswith("generated") and not same(contender.values(), reference):
                        raise SystemExit(f"study: {executables[name]}: not the outputs of the original")
            calls = {}
            for name in times:
                once = running[name].nanoseconds(3)
                calls[name] = max(1, int(block * 1e9 / (running[name].nanoseconds(1000) if once < 20_000 else once)))
            for _ in range(rounds):
                for name in times:
                    running[name].nanoseconds(max(1, calls[name] // 4))
                    times[name].append(running[name].nanoseconds(calls[name]))
        finally:
            for contender in running.values():
                contender.close()
    return {"outputs": len(reference) // measure.VECTORS, "nanoseconds": {name: spread(values, min(values)) for name, values in times.items()},
            "speedup": gains(times)}
