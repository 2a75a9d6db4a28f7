"""A shorter program with the same fault, by C-Reduce (Debian's package creduce), which knows nothing of kernels.

   creduce ──candidate──▶ interesting.py ──▶ session: is the fault there?  is the original's behaviour defined?

C-Reduce removes initialisers, bounds and casts as well, so a candidate counts only if compilers and sanitizers find nothing wrong
with the original on the samples.
"""
import os
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
from dataclasses import dataclass

from .session import HERE, SUFFIX, Session


class ReducedSession(Session):
    """Of one kernel, whose program is a candidate."""
    candidate = ""

    def write(self, kernels):
        shutil.copyfile(self.candidate, self.path)
        return {kernels[0].name: [(1, sys.maxsize)]}


@dataclass
class Case:
    session: dict  # what Session is made of, without a directory
    kernel: object
    kind: str
    seed: int

    def is_in(self, candidate):
        with tempfile.TemporaryDirectory(prefix="kernels-") as directory:
            session = ReducedSession(**self.session, directory=directory, timeout=30)
            session.candidate = os.path.abspath(candidate)
            try:
                outcome = session.execute([self.kernel], self.seed)
                return any(found.kind == self.kind for found in outcome.found) and session.is_defined(self.seed)
            except subprocess.TimeoutExpired:
                return False


def reduced(case, program, seconds, jobs):
    """The shortest program that C-Reduce has found in so many seconds."""
    with tempfile.TemporaryDirectory(prefix="reduce-") as directory:
        name, test = "batch" + SUFFIX[case.session["language"]], os.path.join(directory, "interesting")
        path = os.path.join(directory, name)
        with open(path, "w") as file:
            file.write(program)
        if not case.is_in(path):
            return None  # the behaviour of the original is not defined, or the fault comes and goes
        with open(os.path.join(directory, "case"), "wb") as file:
            pickle.dump(case, file)
        with open(test, "w") as file:
            file.write(f"#!/bin/sh\nexec {sys.executable} {os.path.join(HERE, 'interesting.py')} {directory}/case {name}\n")
        os.chmod(test, 0o755)
        process = subprocess.Popen(["creduce", "--n", str(jobs), test, name], cwd=directory, start_new_session=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        with open(path) as file:
            return file.read()
