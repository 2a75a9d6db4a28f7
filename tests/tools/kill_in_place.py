"""All files or none: kill_in_place.py SYMREAL KILLER TREE WORK

Rewrites copies of a tree in place and kills the process before each of its steps in turn; likewise an undo. No file is ever
half-written, and the next run brings the tree to what it was or to what it should become.
"""
import os
import shutil
import subprocess
import sys

symreal, killer, tree, work = sys.argv[1:]


def content(directory):
    return {name: open(os.path.join(directory, name), "rb").read()
            for name in os.listdir(directory) if not name.startswith(".")}


def left_over(directory):
    return [name for name in os.listdir(directory) if name.startswith(".") and name != ".symreal"]


def run(directory, *words, at=None):
    environment = dict(os.environ)
    if at is not None:
        environment |= {"LD_PRELOAD": killer, "KILL_AT": str(at)}
    return subprocess.run([symreal, *words], cwd=directory, env=environment, capture_output=True, text=True)


def fresh():
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(tree, work)
    return work


sources = sorted(name for name in os.listdir(tree) if not name.endswith(".h"))
rewrite = ["rewrite", "--in-place", *sources]
old = content(fresh())
assert run(work, *rewrite).returncode == 0
new = content(work)
assert old != new


def check(which, first, last, at):
    """Kills `which` at the step; False when it ended before it."""
    done = run(work, *which, at=at)
    if done.returncode == 0:
        assert content(work) == last
        return False
    assert done.returncode == -9, done
    now = content(work)
    assert all(now[name] in (old[name], new[name]) for name in old), "half-written"
    next_run = (["scan", *sources], ["undo"])[at % 2]
    after = run(work, *next_run)
    if "[SYM104]" in after.stderr:
        told.append(at)
    if next_run == ["undo"]:  # taken back or undone; nothing to undo where nothing had happened yet
        assert content(work) == old, (at, after)
    else:
        assert after.returncode == 0 and content(work) in (first, last), (at, after)
    assert not left_over(work), left_over(work)
    if content(work) == new:
        assert run(work, "undo").returncode == 0
    assert content(work) == old and not os.path.exists(os.path.join(work, ".symreal")), at
    return True


told = []  # the steps after which the next run said that it had something to complete or to take back
steps = 1
while fresh() and check(rewrite, old, new, steps):
    steps += 1
undo_steps = 1
while True:
    fresh()
    assert run(work, *rewrite).returncode == 0
    if not check(["undo"], new, old, undo_steps):
        break
    undo_steps += 1
print(f"killed at {steps - 1} steps of a rewrite and {undo_steps - 1} of an undo")
print("told after", len(told), "of them [SYM104]" if told else "")
assert steps > 15 and undo_steps > 10
