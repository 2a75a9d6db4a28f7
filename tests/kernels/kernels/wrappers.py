"""Wrappers of a batch: a program in which one stands in the place of the kernel computes what the original program does, call by
call, also where what is baked in is another value than the recorded one, and where guards fail.

   batch.c, calls.inc                                         ─▶ original ─▶ lines ─┐
   wrappers (+ originals under other names), generated, calls ─▶ swapped  ─▶ lines ─┴ compared

Kernels that need nothing else of their file are in one program, the others in another one. It runs once for each of its kernels. If
it does not compile, each wrapper that is a file of its own is in a program alone.
"""
import glob
import os
import re

from .outcome import Found, Outcome
from .program import beside_others, calls
from .session import GENERATED, HERE, REFERENCE, SANITIZERS, SUFFIX, SUSPICIOUS, Session

CALLS = "-DKERNEL_CALLS=\"calls.inc\""


class WrapperSession(Session):
    """The generated code has a wrapper beside it, which is called."""

    def __init__(self, *words, **named):
        super().__init__(*words, **named)
        self.route = [*self.route, "--wrapper"]
        self.compiler = ["g++", "-std=c++20"] if self.language == "cxx" else ["gcc"]
        self.called, self.wrappers = [], {}

    def compile(self, *words):
        done = self.run(*self.compiler, *REFERENCE, "-I", os.path.join(HERE, "Inputs"), "-I", self.directory, *words)
        return done.stderr[:3000] if done.returncode != 0 else None

    def execute(self, kernels, seed):
        """A kernel that needs nothing else of its file has a wrapper in a file of its own if no other kernel there needs a copy."""
        alone = [k for k in kernels if k.text.lstrip().startswith("#pragma symreal function")]
        outcome = Outcome()
        for group in filter(None, (alone, [k for k in kernels if k not in alone])):
            outcome.add(self.execute_program(group, seed))
        return outcome

    def execute_program(self, kernels, seed):
        outcome = Outcome(count=len(kernels))
        accepted = self.generate(kernels, outcome)
        if not accepted:
            return outcome
        self.called = accepted
        with open(os.path.join(self.directory, "calls.inc"), "w") as file:
            file.write('#include "harness.h"\n' + calls(accepted, lambda kernel: "0"))
        self.run("gcc", "-O1", "-I", os.path.join(HERE, "Inputs"), "-c", os.path.join(HERE, "Inputs", "harness.c"), "-o", "harness.o")
        message = self.compile(CALLS, "-c", os.path.basename(self.path), "-o", "original.o") or \
            self.compile("original.o", "harness.o", "-lm", "-o", "original")
        if message:
            outcome.found.append(Found(accepted[0], "harness", message, self.directory))
            return outcome
        self.run("objcopy", "--weaken", "original.o", "weak.o")
        copies = [k for k in accepted if self.is_copy(k)]
        for group in filter(None, (copies, [k for k in accepted if k not in copies])):
            self.judge_all(group, seed, outcome)
        if self.verify:
            self.verify_all(accepted, outcome)
        return outcome

    def prefix(self, kernel):
        """The begin of the names of generated functions, which have the kernel's name where the batch has several."""
        prefix = self.banner(kernel).get("prefix")
        return prefix + "_" if prefix else ""

    def find_wrappers(self, kernels):
        """Path and text of each kernel's wrapper: its own, or a copy that several kernels share."""
        found = {}
        for path in sorted(glob.glob(os.path.join(self.directory, "out", f"*_wrapper{SUFFIX[self.language]}"))):
            with open(path) as file:
                text = file.read()
            for prefix in re.findall(r"\b(\w*)compute\(double const", text):
                found.setdefault(prefix, (os.path.relpath(path, self.directory), text))
        return {k.name: found[prefix] for k in kernels if (prefix := self.prefix(k)) in found}

    def is_copy(self, kernel):
        return "KERNEL_CALLS" in self.wrappers[kernel.name][1]

    def write_lines(self, name, lines):
        with open(os.path.join(self.directory, name), "w") as file:
            file.write("\n".join(lines) + "\n")

    def swap(self, kernels):
        """The program with wrappers in place of the kernels, all of which are copies or none; a message where something does not compile."""
        self.write_lines("generated.c", [line for k in kernels for line in beside_others(k.name, os.path.join(self.directory, "out", k.name + ".c"))])
        done = self.run("gcc", *GENERATED, "-c", "generated.c", "-o", "generated.o")
        broken = next(filter(None, map(self.compile_alone, kernels)), None) if not self.verify else None  # verify compiles each alone
        if broken or done.returncode != 0:
            return (broken or done.stderr)[:3000]
        computes = {self.prefix(k) + "compute": self.guards(k) for k in kernels}
        self.write_lines("count.c", ["extern int computed;"] + [
            f"int __real_{compute}(double const *, double const *, double *);\n"
            f"int __wrap_{compute}(double const *in, double const *constants, double *out) {{\n"
            f"  int guard = __real_{compute}(in, constants, out);\n  computed += {'guard == 0' if guards else '1'};\n"
            "  return guard;\n}" for compute, guards in computes.items()])
        self.run("gcc", "-O1", "-c", "count.c", "-o", "count.o")
        objects, is_copy = ["generated.o", "count.o", "harness.o"], self.is_copy(kernels[0])
        for number, path in enumerate(sorted({self.wrappers[k.name][0] for k in kernels})):
            objects.append(f"wrapper{number}.o")
            message = self.compile(*[CALLS] * is_copy, "-I", "out", "-c", path, "-o", objects[-1])
            if message:
                return message
        if not is_copy:
            message = self.compile(*(f"-D{k.name}={self.prefix(k)}fallback" for k in kernels), "-Dmain=another_main", "-c",
                                   os.path.basename(self.path), "-o", "fallback.o")
            if message:
                return message
            self.run("objcopy", "--weaken", "fallback.o")
            objects += ["weak.o", "fallback.o"]
        # A reference of the weakened objects to a library is weak as well.
        return self.compile(*objects, *(f"-Wl,--wrap={compute}" for compute in computes), "-Wl,--no-as-needed", "-lm", "-o", "swapped")

    def guards(self, kernel):
        return bool(self.banner(kernel).get("guards"))

    def stops(self, kernel):
        """Another value that is baked in ends the program, which has not got the original to call."""
        return not self.is_copy(kernel) and "fallback" not in self.wrappers[kernel.name][1]

    def judge_all(self, kernels, seed, outcome):
        message = self.swap(kernels)
        if message and len(kernels) > 1 and not self.is_copy(kernels[0]):
            for kernel in kernels:
                self.judge_all([kernel], seed, outcome)
        elif message:
            outcome.found += [Found(k, "wrapper does not compile", message, self.directory) for k in kernels]
        else:
            for kernel in kernels:
                self.judge(kernel, seed, outcome)

    def judge(self, kernel, seed, outcome):
        plains = 0 if self.stops(kernel) else len(kernel.interface.plains)
        words = [self.mode, str(seed), str(self.samples), kernel.name, str(plains)]
        original, swapped = self.run("./original", *words).stdout.splitlines(), self.run("./swapped", *words)
        lines = swapped.stdout.splitlines()
        if len(lines) != len(original):
            outcome.found.append(Found(kernel, "wrapper ends the program", swapped.stderr[-2000:] + "\n".join(lines[-1:]), self.directory))
            return
        computed, skipped = int(lines[-1].split()[1]), None
        outcome.guarded += len(lines) - 1 - computed
        for expected, got in zip(original[:-1], lines[:-1]):
            sample, call, outside, changed, *numbers = expected.split()
            if outside == "1" or skipped == sample:
                outcome.outside, skipped = outcome.outside + 1, sample  # state goes on to later calls
                continue
            outcome.samples += 1
            if not all(self.same(a, b) for a, b in zip(numbers, got.split()[4:])):
                outcome.found.append(Found(kernel, "wrapper differs", f"original {expected}\nwrapper  {got}", self.directory))
                return
        if computed == 0:
            outcome.found.append(Found(kernel, "wrapper never calls generated code", "", self.directory))
            return
        outcome.compared += 1

    def is_defined(self, seed):
        flags = [*(flag for flag in REFERENCE if flag != "-w"), *SUSPICIOUS, *SANITIZERS]
        built = self.run(*self.compiler, *flags, "-I", os.path.join(HERE, "Inputs"), "-I", self.directory, CALLS,
                         os.path.basename(self.path), "harness.o", "-lm", "-o", "checked")
        if built.returncode != 0:
            return False
        said = [self.run("./checked", self.mode, str(seed), str(self.samples), k.name, str(len(k.interface.plains))).stderr for k in self.called]
        return not any("runtime error" in text or "Sanitizer" in text for text in said)

    def same(self, a, b):
        if "nan" in a or "nan" in b:
            return "nan" in a and "nan" in b
        return a == b or self.mode != "strict" and float.fromhex(a) == float.fromhex(b)

    def generate(self, kernels, outcome):
        accepted = super().generate(kernels, outcome)
        self.wrappers = self.find_wrappers(accepted)
        outcome.found += [Found(k, "no wrapper", "", self.directory) for k in accepted if k.name not in self.wrappers]
        return [k for k in accepted if k.name in self.wrappers]
