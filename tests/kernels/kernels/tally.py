"""What all batches of a run have given: a summary, and a record in a file, one JSON line a batch.

A run that is given the file of an earlier one takes the outcomes of its batches from there.
"""
import json
import os
import threading
import time
from collections import Counter

from .outcome import Outcome

COUNTS = ("count", "compared", "samples", "guarded", "outside", "verified", "recorded_twice")
# The options, apart from what a batch is, on which its outcome depends.
OPTIONS = ("seed", "samples", "without", "only", "often", "open", "verify", "oracle", "wrapper", "instructions")


class Tally:
    def __init__(self, options):
        self.options, self.start, self.lock = options, time.monotonic(), threading.Lock()
        self.totals, self.known, self.now = {}, {}, 0
        if options.tally and os.path.exists(options.tally):
            with open(options.tally) as file:
                self.known = {self.key(record["batch"]): record for record in map(json.loads, file)}

    def batch(self, language, policy, mode, indices):
        return {"language": language, "policy": policy, "mode": mode, "first": indices.start, "end": indices.stop,
                **{name: getattr(self.options, name) for name in OPTIONS}}

    @staticmethod
    def key(batch):
        return json.dumps(batch, sort_keys=True)

    def total(self, language, policy):
        return self.totals.setdefault((language, policy), Outcome())

    def takes(self, *batch):
        """Whether the file has the outcome of the batch, which is added then."""
        record = self.known.get(self.key(self.batch(*batch)))
        if not record:
            return False
        with self.lock:
            self.total(*batch[:2]).add(Outcome(**{name: record[name] for name in COUNTS}, refused=Counter(record["refused"]),
                                               not_twice=Counter(record["not_twice"]), found=record["faults"]))
        return True

    def add(self, batch, outcome):
        record = {"batch": self.batch(*batch), **{name: getattr(outcome, name) for name in COUNTS}, "refused": outcome.refused,
                  "not_twice": outcome.not_twice, "faults": [f"{found.kind}: seed {found.kernel.seed}" for found in outcome.found]}
        with self.lock:
            self.total(*batch[:2]).add(outcome)
            self.now += outcome.count
            if self.options.tally:
                with open(self.options.tally, "a") as file:
                    file.write(json.dumps(record) + "\n")

    def faults(self):
        return sum(len(o.found) for o in self.totals.values())

    def show(self):
        totals = {key: o for key, o in self.totals.items() if o.count}
        print("language policy  kernels  equal  refused  different  verified   samples  guarded  outside")
        for (language, policy), o in totals.items():
            print(f"{language:8} {policy:7} {o.count:7} {o.compared:6} {sum(o.refused.values()):8} {len(o.found):10} {o.verified:9} "
                  f"{o.samples:9} {o.guarded:8} {o.outside:8}")
        for (language, policy), o in totals.items():
            print(f"refused, {language} {policy}: " + ", ".join(f"{why} {n}" for why, n in o.refused.most_common()))
        if self.options.oracle:
            for (language, policy), o in totals.items():
                print(f"recorded twice, {language} {policy}: {o.recorded_twice} equal; not taken: "
                      + ", ".join(f"{why} {n}" for why, n in o.not_twice.most_common()))
        kernels, seconds = sum(o.count for o in totals.values()), time.monotonic() - self.start
        earlier = f" ({kernels - self.now} of them recorded before)" if kernels != self.now else ""
        print(f"{kernels} kernels{earlier}, {self.faults()} faults, {seconds:.0f} s, {60 * self.now / seconds:.0f} kernels a minute", flush=True)
