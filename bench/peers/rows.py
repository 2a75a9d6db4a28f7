"""A row: its contenders made, compared, and timed in turns."""
import math
import random
import struct
from concurrent.futures import ThreadPoolExecutor

import contenders
import exact
from work import WORK, Missing, digest, remembered, run

VECTORS = 16
AGREE = 1e-9


def outputs(kernel, joints):
    return {"fk": 12, "crba": joints * joints}.get(kernel, joints)


def inputs(kernel, joints):
    """Input vectors, always the same: angles and rates of some size, accelerations or torques."""
    draw = random.Random(joints).uniform
    parts = 3 if kernel in ("rnea", "aba") else 1
    return [[draw(-3, 3) if place < joints else draw(-1, 1) for place in range(parts * joints)] for _ in range(VECTORS)]


def turns(kernel, joints, objects, rounds, seconds=0.0, seed=1):
    vectors = inputs(kernel, joints)
    file = WORK / "inputs" / f"{kernel}-{joints}"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(b"".join(struct.pack(f"{len(vector)}d", *vector) for vector in vectors))
    program = WORK / "turns"
    return run([program, kernel, joints, contenders.model_table(), file, len(vectors[0]), outputs(kernel, joints), rounds, seconds, seed,
                *objects])[0]


def build_turns():
    run(["gcc", "-std=gnu11", "-O2", f"-I{contenders.HERE}", contenders.HERE / "turns.c", "-o", WORK / "turns", "-ldl"])


def prepare(kernel, joints, smaller, names):
    """The row without times: `smaller` is the row with the next smaller number of joints."""
    names = [name for name in names if joints >= contenders.LOOPS or not name.endswith("--reroll")]
    with ThreadPoolExecutor(2) as pool:
        made = list(pool.map(lambda name: contenders.contender(name, kernel, joints, smaller.get(name) if smaller else None), names))
    row = dict(zip(names, made))
    compare(kernel, joints, row)
    return row


def variants(row):
    return [(name, level) for name, contender in row.items() for level in contender.get("variants", {})]


def values_of(kernel, joints, path):
    """The outputs at all input vectors, or why there are none."""
    try:
        return turns(kernel, joints, [path], 0)
    except Missing as reason:
        return str(reason)


def compare(kernel, joints, row):
    """All must agree; strict to the bit and finite in value with the original's reference build. Notes errors as well."""
    every = variants(row)
    objects = [row[name]["variants"][level]["object"] for name, level in every]
    key = digest(kernel, joints, *objects, AGREE, *((contenders.HERE / name).read_text() for name in ("exact.py", "chain.py", "rows.py")))

    def make():
        count = outputs(kernel, joints)
        values = {each: values_of(kernel, joints, path) for each, path in zip(every, objects)}
        reference = values[("original", "reference")]
        true = struct.unpack(f"{count * VECTORS}d", reference)
        scales = [max(abs(x) for x in true[k * count:(k + 1) * count]) for k in range(VECTORS)]
        references = exact.outputs(kernel, joints, inputs(kernel, joints))
        found, allowed = [], AGREE
        for (name, level), data in values.items():
            if isinstance(data, str):
                found.append({"missing": data})
                continue
            numbers = struct.unpack(f"{count * VECTORS}d", data)
            if name == "Symreal strict" and data != reference and any(
                    struct.pack("d", a) != struct.pack("d", b) and not (a != a and b != b) for a, b in zip(numbers, true)):
                raise SystemExit(f"bench: {kernel} {joints}: {name}, {level}, has not the bits of the reference build")
            if name.startswith("Symreal finite") and any(a != b for a, b in zip(numbers, true)):
                raise SystemExit(f"bench: {kernel} {joints}: {name}, {level}, has not the values of the reference build")
            distance = max(abs(a - b) / scales[place // count] for place, (a, b) in enumerate(zip(numbers, true)))
            if name == "original":
                allowed = max(allowed, 100 * distance)
            if not distance < allowed or not all(map(math.isfinite, numbers)):
                raise SystemExit(f"bench: {kernel} {joints}: {name}, {level}, is off by {distance:.1e}")
            found.append({"difference": distance, "error": exact.error(references, numbers, count)})
        return found
    for (name, level), found in zip(every, remembered(key, make)):
        if "missing" in found:
            row[name] = {"missing": found["missing"], "joints": joints}
        elif "variants" in row[name]:
            row[name]["variants"][level].update(found)


def measure(kernel, joints, row, rounds, launches, seconds):
    """Adds to each variant its times, turn by turn."""
    every = [each for each in variants(row) if each[1] != "reference"]
    objects = [row[name]["variants"][level]["object"] for name, level in every]
    times = [[] for _ in every]
    for launch in range(launches):
        for line in turns(kernel, joints, objects, rounds, seconds, launch + 1).decode().splitlines():
            for place, word in enumerate(line.split()):
                times[place].append(float(word))
    for (name, level), of_variant in zip(every, times):
        row[name]["variants"][level]["times"] = of_variant
