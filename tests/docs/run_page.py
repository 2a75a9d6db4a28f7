"""Runs the commands of a page and compares what they print with what the page says.   run_page.py PAGE TOOLS WORK

A block whose lines begin with "$ " holds commands, each with its output below it. They run one after the other, in WORK, which has
copies of what the repository has in inputs/ and tests/, with the directory TOOLS in PATH. In the output

  ...          stands for any lines where it is a line, elsewhere for any text
  0.92 s       a time is equal to any other
  0.0524471    so is a number with six decimals or ten digits to another: they depend on the machine

A comment before a block says what else the block is: <!-- part of FILE --> the text stands in the file; <!-- written to FILE -->
the commands below use it. Other blocks are left alone.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

page, tools, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
root = page.parents[2]

BLOCK = re.compile(r"(?:^<!-- (part of|written to) (\S+) -->\n)?^```\w*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
VARYING = re.compile(r"\b\d+\.\d+ s\b|-?\b\d+\.\d{6,}(?:e[-+]?\d+)?|\b\d{10,}\b|(?<=functions of the original: ).*")


def normal(text):
    return "".join(VARYING.sub("#", line).rstrip() + "\n" for line in text.splitlines())


def pattern(text):
    """The text as a regular expression, in which "..." stands for anything."""
    expression = ""
    for line in normal(text).splitlines():
        if line.strip() == "...":
            expression += r"(?:.*\n)*?"
        else:
            expression += ".*".join(re.escape(part) for part in line.split("...")) + r"\n"
    return re.compile(expression)


class Shell:
    """Runs commands, each in the directory in which the last one ended."""

    def __init__(self, directory):
        self.directory = directory

    def run(self, command):
        mark = "==directory=="
        script = f"{command}\necho; echo {mark}; pwd"
        environment = dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}", LC_ALL="C")
        done = subprocess.run(["bash", "-c", script], cwd=self.directory, env=environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        output, _, directory = done.stdout.rpartition(f"\n{mark}\n")
        self.directory = pathlib.Path(directory.strip())
        return output


def commands(block):
    """Each command of a block with the text below it."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, output = part.partition("\n")
        yield command, output


shutil.rmtree(work, ignore_errors=True)
for name in ("inputs", "tests/tool", "tests/bad_input", "tests/analysis"):
    shutil.copytree(root / name, work / name)
shell = Shell(work)
count = wrong = 0


def compare(what, wanted, given, matches):
    global count, wrong
    count += 1
    if not matches(pattern(wanted), normal(given)):
        wrong += 1
        print(f"{page.name}: {what}", "the page says:", wanted, "but there is:", given, sep="\n")


for kind, name, block in BLOCK.findall(page.read_text()):
    if kind == "written to":
        (shell.directory / name).write_text(block)
    elif kind == "part of":
        compare(name, block, (shell.directory / name).read_text(), re.Pattern.search)
    elif block.startswith("$ "):
        for command, wanted in commands(block):
            compare(command, wanted, shell.run(command), re.Pattern.fullmatch)
print(f"{count} commands and excerpts, {wrong} wrong")
sys.exit(1 if wrong or not count else 0)
