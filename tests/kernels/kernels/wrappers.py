"""Wrappers of a batch: a program in which one stands in the place of the kernel computes what the original program does, call by
call, also where what is baked in is another value than the recorded one, and where guards fail.

   batch.c, calls.inc ─▶ original                            ─▶ lines ─┐
   wrapper (+ original under another name), kernel.c, calls  ─▶ lines ─┴ compared

A wrapper that is a copy of the batch has all kernels that share it.
"""
import glob
import os
import re

from .outcome import Found, Outcome
from .program import calls
from .session import GENERATED, HERE, REFERENCE, SANITIZERS, SUFFIX, SUSPICIOUS, Session

CALLS = "-DKERNEL_CALLS=\"calls.inc\""


class WrapperSession(Session):
    """The generated code has a wrapper beside it, which is called."""

    def __init__(self, *words, **named):
        super().__init__(*words, **named)
        self.route = [*self.route, "--wrapper"]
        self.compiler = ["g++", "-std=c++20"] if self.language == "cxx" else ["gcc"]
        self.called = []

    def compile(self, *words):
        done = self.run(*self.compiler, *REFERENCE, "-I", os.path.join(HERE, "Inputs"), "-I", self.directory, *words)
        return done.stderr[:3000] if done.returncode != 0 else None

    def execute(self, kernels, seed):
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
        for kernel in accepted:
            self.judge(kernel, seed, outcome)
        if self.verify:
            self.verify_all(accepted, outcome)
        return outcome

    def prefix(self, kernel):
        """The begin of the names of generated functions, which have the kernel's name where the batch has several."""
        prefix = self.banner(kernel).get("prefix")
        return prefix + "_" if prefix else ""

    def wrapper(self, kernel):
        """Path and text of the kernel's wrapper: its own, or a copy that several kernels share; None if it has none."""
        for path in sorted(glob.glob(os.path.join(self.directory, "out", f"*_wrapper{SUFFIX[self.language]}"))):
            with open(path) as file:
                text = file.read()
            if re.search(rf"\b{self.prefix(kernel)}compute\(double const", text):
                return os.path.relpath(path, self.directory), text
        return None

    def swap(self, kernel):
        """The program with the wrapper in place of the kernel; a message where something does not compile."""
        wrapper, text = self.wrapper(kernel)
        compute, is_copy = self.prefix(kernel) + "compute", "KERNEL_CALLS" in text
        called = [k for k in self.called if k is kernel or is_copy and self.wrapper(k)[0] == wrapper]
        objects = ["count.o", "harness.o"]
        for one in called:
            done = self.run("gcc", *GENERATED, "-c", f"out/{one.name}.c", "-o", f"{one.name}_generated.o")
            objects.append(f"{one.name}_generated.o")
            if done.returncode != 0:
                return done.stderr[:3000]
        with open(os.path.join(self.directory, "count.c"), "w") as file:
            file.write(f"extern int computed;\nint __real_{compute}(double const *, double const *, double *);\n"
                       f"int __wrap_{compute}(double const *in, double const *constants, double *out) {{\n"
                       f"  int guard = __real_{compute}(in, constants, out);\n  computed += {'guard == 0' if self.guards(kernel) else '1'};\n"
                       "  return guard;\n}\n")
        self.run("gcc", "-O1", "-c", "count.c", "-o", "count.o")
        if is_copy:
            message = self.compile(CALLS, "-I", "out", "-c", wrapper, "-o", "wrapper.o")
            objects += ["wrapper.o"]
        else:
            message = self.compile("-I", "out", "-c", wrapper, "-o", "wrapper.o") or \
                self.compile(f"-D{kernel.name}={self.prefix(kernel)}fallback", "-Dmain=another_main", "-c", os.path.basename(self.path), "-o", "fallback.o")
            self.run("objcopy", "--weaken", "fallback.o")
            objects += ["wrapper.o", "weak.o", "fallback.o"]
        # A reference of the weakened objects to a library is weak as well.
        return message or self.compile(*objects, f"-Wl,--wrap={compute}", "-Wl,--no-as-needed", "-lm", "-o", "swapped")

    def guards(self, kernel):
        return bool(self.banner(kernel).get("guards"))

    def stops(self, kernel):
        """Another value that is baked in ends the program, which has not got the original to call."""
        text = self.wrapper(kernel)[1]
        return "KERNEL_CALLS" not in text and "fallback" not in text

    def judge(self, kernel, seed, outcome):
        message = self.swap(kernel)
        if message:
            outcome.found.append(Found(kernel, "wrapper does not compile", message, self.directory))
            return
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
        return [k for k in accepted if self.wrapper(k) or outcome.found.append(Found(k, "no wrapper", "", self.directory))]
