"""One batch: one program of many kernels, generated in one run, compared by the harness.

A kernel that the tool refuses takes its batch along, so the kernels at whose lines errors stand are counted as refused and left
out, and the rest runs again: of the same program if that is compiled already.
"""
import json
import os
import re
import subprocess
import threading

from .features import MUST_BE_REFUSED, refused
from .messages import ERROR, calls_as_errors
from .outcome import Found, Outcome
from .program import glue, probe, source
from .second_recording import record_twice

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SUFFIX = {"c": ".c", "cxx": ".cpp"}
# The reference build of docs/reference/floating-point.md, and the flags that it gives for generated code.
REFERENCE = ["-O1", "-ffp-contract=off", "-fno-builtin", "-fno-fast-math", "-w"]
SANITIZERS = ["-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all"]
SUSPICIOUS = ["-Wall", "-Werror=uninitialized", "-Werror=maybe-uninitialized", "-Werror=return-type", "-Werror=array-bounds"]
GENERATED = ["-std=c99", "-O2", "-ffp-contract=off", "-fno-tree-slp-vectorize", "-fno-builtin-pow", "-w"]
# A decision that the policy does not have, an output that depends on no input, a kernel that has no wrapper.
OF_POLICIES = {"SYM016", "SYM051", "SYM095"}


running, stopped = set(), threading.Event()  # of all sessions


class Stopped(Exception):
    """The run has been interrupted."""


def stop():
    """Ends the programs of all sessions."""
    stopped.set()
    for process in list(running):
        process.terminate()


class Session:
    def __init__(self, symreal, language, policy, mode, directory, samples=60, verify=False, oracle=False, quick=True,
                 timeout=3600, instructions=False, cache=None):
        self.symreal, self.language, self.policy, self.mode = symreal, language, policy, mode
        self.directory, self.samples, self.verify, self.timeout = directory, samples, verify, timeout
        self.quick, self.oracle, self.route = quick, oracle, ["--record=instructions"] if instructions else []
        self.cache = cache or directory  # verify needs the program that generate has built
        self.path, self.places = os.path.join(directory, "batch" + SUFFIX[language]), {}

    def run(self, *words):
        environment = {**os.environ, "XDG_CACHE_HOME": self.cache}
        with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.directory, errors="replace",
                              env=environment) as process:
            running.add(process)
            try:
                if stopped.is_set():
                    raise Stopped
                stdout, stderr = process.communicate(timeout=self.timeout)
            except BaseException:
                process.kill()
                raise
            finally:
                running.discard(process)
        if stopped.is_set():
            raise Stopped
        return subprocess.CompletedProcess(words, process.returncode, stdout, stderr)

    def symreal_run(self, command, *words):
        quick = [f"--cxx={os.path.join(HERE, 'unoptimised.py')}"] if self.quick and self.language == "c" else []
        return self.run(self.symreal, command, self.path, *words, *quick)

    def write(self, kernels):
        text, places = source(kernels, self.language)
        with open(self.path, "w") as file:
            file.write(text)
        return places

    def generate(self, kernels, outcome):
        """The kernels that the tool accepts; the generated code of all of them lies in out/."""
        written = []
        while kernels:
            if not written:
                written, places = kernels, self.write(kernels)
                self.places = places
            chosen = [] if written is kernels else ["--kernel=" + ",".join(k.name for k in kernels)]
            self.run("rm", "-rf", "out")
            os.makedirs(os.path.join(self.directory, "out"))
            try:
                done = self.symreal_run("generate", "-o", "out/", f"--decisions={self.policy}", f"--fp={self.mode}",
                                        *self.route, *chosen)
            except subprocess.TimeoutExpired:
                done = subprocess.CompletedProcess([], 1, "", "time is over")
            if done.returncode == 0:
                outcome.found += [Found(k, f"taken, though it must be refused: {' or '.join(sorted(k.expected))}", "", self.directory)
                                  for k in kernels if k.expected]
                return [k for k in kernels if not k.expected]
            named = self.refusals(calls_as_errors(done.stderr), places)
            if not named and len(kernels) == 1:
                named = {kernels[0].name: [self.reason(done.stderr)]}
            if named:
                for kernel in kernels:
                    if kernel.name in named:
                        self.judge_refusal(kernel, named[kernel.name], done.stderr, outcome)
                left = [k for k in kernels if k.name not in named]
                if len(left) == len(kernels) or not all(OF_POLICIES.issuperset(ids) for ids in named.values()):
                    written = []  # a kernel is refused even where it is not recorded
                kernels = left
            else:
                written, half = [], len(kernels) // 2
                accepted = self.generate(kernels[:half], outcome) + self.generate(kernels[half:], outcome)
                if len(accepted) == len([k for k in kernels if not k.expected]):
                    outcome.found.append(Found(kernels[0], "together", done.stderr[-2000:], self.directory))
                    return self.generate(kernels[:half], Outcome())
                kernels = accepted
        return []

    @staticmethod
    def reason(text):
        ids = re.findall(r"error: .*\[(SYM\d+)\]", text)
        return ids[0] if ids else "compiler" if "error" in text else "no reason"

    def judge_refusal(self, kernel, ids, text, outcome):
        """A kernel is refused by what the generator expects, or by what the policy and the last of a thousand may have."""
        if "SYM020" in ids:
            return outcome.found.append(Found(kernel, "invalid: the generator's fault", text, self.directory))
        if "SYM095" in ids and "does not compile" in self.around(text, kernel):
            outcome.found.append(Found(kernel, "wrapper does not compile", self.around(text, kernel), self.directory))
        elif not kernel.expected & set(ids) and not OF_POLICIES & set(ids) and not kernel.features & set(refused(self.language)) - MUST_BE_REFUSED:
            word = "refused for another reason than " + " or ".join(sorted(kernel.expected)) if kernel.expected else "refused, though it is right"
            outcome.found.append(Found(kernel, f"{word}: {', '.join(ids)}", self.around(text, kernel), self.directory))
        outcome.refused[ids[0]] += 1
        outcome.features_refused.update(kernel.features)
        self.keep_refusal(kernel, ids[0], text)

    @staticmethod
    def refusals(text, places):
        """The diagnostics of each kernel at whose lines there are errors."""
        named = {}
        for line in text.splitlines():
            match = ERROR.match(line)
            if not match:
                continue
            number = int(match.group(1))
            for name, ranges in places.items():
                if any(first <= number <= last for first, last in ranges):
                    ids = named.setdefault(name, [])
                    ids += [match.group(3) or "compiler"] * ((match.group(3) or "compiler") not in ids)
        return named

    def around(self, text, kernel):
        """The text around the errors of a kernel."""
        lines = text.splitlines()
        hits = [k for k, line in enumerate(lines) if self.refusals(line, {kernel.name: self.places[kernel.name]})]
        return "\n".join(line for hit in hits[:3] for line in lines[hit:hit + 6]) or text[-2000:]

    def keep_refusal(self, kernel, why, text):
        folder = os.environ.get("KERNELS_KEEP_REFUSED")
        if folder:
            os.makedirs(os.path.join(folder, why), exist_ok=True)
            with open(os.path.join(folder, why, f"{self.language}-{self.policy}-{kernel.seed.replace('/', '-')}"), "w") as file:
                file.write(f"{kernel.text}\n{text}")

    def banner(self, kernel):
        with open(os.path.join(self.directory, "out", kernel.name + ".c")) as file:
            return json.loads(file.readline().removeprefix("/* symreal "))

    def build(self, kernels):
        """The harness with the originals and the generated code; a message where something does not compile."""
        write = lambda name, text: open(os.path.join(self.directory, name), "w").write(text)
        probe_name = "probe" + SUFFIX[self.language]
        write(probe_name, probe(self.path, kernels, self.language))
        write("generated.c", "".join(glue(k, os.path.join(self.directory, "out", k.name + ".c"), self.banner(k)) for k in kernels))
        compiler = ["g++", "-std=c++20"] if self.language == "cxx" else ["gcc"]
        include = ["-I", os.path.join(HERE, "Inputs")]
        for words in ([*compiler, *REFERENCE, *include, "-c", probe_name, "-o", "probe.o"],
                      ["gcc", *GENERATED, "-c", "generated.c", "-o", "generated.o"],
                      ["gcc", "-O1", *include, "-c", os.path.join(HERE, "Inputs", "harness.c"), "-o", "harness.o"],
                      [compiler[0], "probe.o", "generated.o", "harness.o", "-lm", "-o", "harness"]):
            done = self.run(*words)
            if done.returncode != 0:
                return " ".join(words) + "\n" + done.stderr[:3000]
        return None

    def compile_alone(self, kernel):
        done = self.run("gcc", *GENERATED, "-fsyntax-only", f"out/{kernel.name}.c")
        return done.stderr if done.returncode != 0 else None

    def execute(self, kernels, seed):
        outcome = Outcome(count=len(kernels))
        accepted = self.generate(kernels, outcome)
        if accepted:
            message = self.build(accepted)
            if message:
                broken = [(k, m) for k in accepted if (m := self.compile_alone(k))]
                outcome.found += [Found(k, "broken", m, self.directory) for k, m in broken]
                accepted = [k for k in accepted if k not in [b for b, _ in broken]]
                if not broken:
                    outcome.found.append(Found(accepted[0], "harness", message, self.directory))
                    return outcome
                message = self.build(accepted)
                if message:
                    outcome.found.append(Found(accepted[0], "harness", message, self.directory))
                    return outcome
        if not accepted:
            return outcome
        done = self.run("./harness", self.mode, str(seed), str(self.samples))
        self.read(done.stdout, accepted, outcome)
        if self.verify:
            self.verify_all(accepted, outcome)
        if self.oracle:
            record_twice(self, accepted, outcome)
        return outcome

    def is_defined(self, seed):
        """Whether the originals of the last batch, as they stand in the harness, do nothing that they must not."""
        compiler = ["g++", "-std=c++20"] if self.language == "cxx" else ["gcc"]
        flags = [*(flag for flag in REFERENCE if flag != "-w"), *SUSPICIOUS, *SANITIZERS]
        for words in ([*compiler, *flags, "-I", os.path.join(HERE, "Inputs"), "-c", "probe" + SUFFIX[self.language], "-o", "checked.o"],
                      [compiler[0], *SANITIZERS, "checked.o", "generated.o", "harness.o", "-lm", "-o", "checked"]):
            if self.run(*words).returncode != 0:
                return False
        said = self.run("./checked", self.mode, str(seed), str(self.samples)).stderr
        return "runtime error" not in said and "Sanitizer" not in said

    def read(self, text, kernels, outcome):
        by_name = {k.name: k for k in kernels}
        blocks = re.split(r"^(?=\S)", text, flags=re.M)
        for block in filter(None, blocks):
            name, verdict, compared, guarded, outside = block.splitlines()[0].split()
            outcome.samples += int(compared)
            outcome.guarded += int(guarded)
            outcome.outside += int(outside)
            kernel = by_name.pop(name)
            if verdict == "ok":
                outcome.compared += 1
            else:
                outcome.found.append(Found(kernel, verdict, block, self.directory))
        outcome.found += [Found(k, "no verdict", "", self.directory) for k in by_name.values()]

    def verify_all(self, kernels, outcome):
        """`symreal verify` must say of each kernel what the harness said."""
        different = {f.kernel.name for f in outcome.found}
        files = [f"out/{k.name}.c" for k in kernels]
        done = self.symreal_run("verify", *files, f"--samples={self.samples}", "--min-samples=1")
        if done.returncode not in (0, 3):
            told = re.findall(r"^.*\berror: .*(?:\n.*){6}", done.stderr, flags=re.M)
            outcome.found.append(Found(kernels[0], "verify fails", "\n".join(told) or done.stderr[-3000:], self.directory))
            return
        outcome.verified += len(kernels)
        told = set(re.findall(r"^(?:\S*/)?out/(\w+)\.c: error:(?!.*\[SYM092\])", done.stderr, flags=re.M))
        for kernel in kernels:
            if (kernel.name in told) != (kernel.name in different):
                word = "verify tells of a difference that the harness does not see" if kernel.name in told else "verify misses it"
                told_of = [block for block in re.split(r"^(?=kernel |out/)", done.stderr, flags=re.M)
                           if block.startswith((f"kernel {kernel.name},", f"out/{kernel.name}.c"))]
                outcome.found.append(Found(kernel, word, "".join(told_of), self.directory))
