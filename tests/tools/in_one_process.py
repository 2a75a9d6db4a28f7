"""Runs of a main program whose system takes seconds to start: all lists of inputs in one process. The program has a
function `run` of a list of arguments, which prints as the program does and gives its status."""
import math
import os
import re
import subprocess
import types

HERE = os.path.dirname(os.path.abspath(__file__))
MARK = "=== run"


SHOW = """bits[x_, scale_] := "bits " <> ToString[IntegerPart[x]] <> " " <> ToString[scale];
show[x_Real] := Which[x == 0, "0", Abs[x] >= 2^1024, "inf", Abs[x] >= 2^53, bits[x, 0], Abs[x] >= 1, bits[x*2.0`^60, -60],
  Abs[x] >= 2.0`^-480, bits[x*2.0`^537, -537], True, bits[x*2.0`^537*2.0`^537, -1074]];
"""
BITS = re.compile(r"bits (-?\d+) (-?\d+)")


def decimal(text):
    return BITS.sub(lambda bits: repr(math.ldexp(int(bits[1]), int(bits[2]))), text)


def mathematica(name, lists):
    """Behind what Mathics lacks of Mathematica. It prints numbers of 16 digits, so their bits are asked for."""
    text = f'Get["{HERE}/mathics.wl"]; onlyDefines = True; Get["{name}_main.wl"];\n' + SHOW
    for inputs in lists:
        arguments = ", ".join(repr(float(x)).replace("e", "`*^") if "e" in x else x + ("`" if "." in x else ".`") for x in inputs)
        text += f'Print["{MARK}"]; WriteString["stderr", "{MARK}\\n"]; Print["{MARK} ", run[{{{arguments}}}]];\n'
    return text


LANGUAGES = {"mathematica": (mathematica, ".wl", [os.path.join(HERE, "../../build/venv/bin/mathics"), "-f"])}


class Runs:
    def __init__(self, language, base):
        self.language, self.base = language, os.path.abspath(base)
        self.results = {}

    def prepare(self, lists):
        program, ending, command = LANGUAGES[self.language]
        where, name = os.path.split(self.base)
        with open(f"{self.base}_runs{ending}", "w") as file:
            file.write(program(name, lists))
        done = subprocess.run(command + [f"{name}_runs{ending}"], cwd=where, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)
        outputs, errors = done.stdout.split(f"{MARK}\n")[1:], done.stderr.split(f"{MARK}\n")[1:]
        if len(outputs) != len(lists) or len(errors) != len(lists):
            raise SystemExit(f"{self.language}: {done.stdout[-2000:]}\n{done.stderr[-2000:]}")
        for inputs, output, error in zip(lists, outputs, errors):
            text, _, status = output.partition(f"{MARK} ")
            self.results[tuple(inputs)] = types.SimpleNamespace(returncode=int(status or 0), stdout=decimal(text), stderr=error)

    def __call__(self, inputs):
        return self.results[tuple(inputs)]
