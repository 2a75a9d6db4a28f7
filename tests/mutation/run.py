#!/usr/bin/env python3
"""Drops the rules, one at a time, and tells what notices: the net (`generate` and `verify`), and the tests.

It needs a build that was configured with -DSYMREAL_MUTATION=ON. docs/trust/mutation.md has the results.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from rules import RULES

HERE = os.path.dirname(os.path.abspath(__file__))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", default="build/mutation", help="the build directory")
    parser.add_argument("--rules", default="", help="only these, separated by commas")
    parser.add_argument("--net", action="store_true", help="only the net")
    parser.add_argument("--tests", action="store_true", help="only the tests")
    parser.add_argument("--granted", action="store_true", help="take for granted that nothing is noticed without a mutation")
    parser.add_argument("--jobs", "-j", type=int, default=1)
    parser.add_argument("--lit", default="/usr/lib/llvm-19/build/utils/lit/lit.py")
    parser.add_argument("--verbose", action="store_true", help="show what the tool says")
    return parser.parse_args()


def environment(rule):
    return dict(os.environ, SYMREAL_DROP_RULE=rule) if rule else {k: v for k, v in os.environ.items() if k != "SYMREAL_DROP_RULE"}


def reason(done):
    """The ids of the errors, else its last words."""
    ids = sorted(set(re.findall(r"error: .*\[(SYM\d+)\]", done.stderr)))
    return " ".join(ids) or (done.stderr.strip().splitlines() or [f"status {done.returncode}"])[-1]


def library(rule, directory):
    """What the program is linked with, where the rule is about that."""
    path = os.path.join(HERE, "Inputs", "_library".join(os.path.splitext(rule.program)))
    if not os.path.exists(path):
        return ()
    subprocess.run(["gcc", "-c", "-O1", path, "-o", os.path.join(directory, "library.o")], check=True)
    return (f"--link={directory}/library.o",)


def warm_cache(options):
    """Objects that any run would compile first. Each run gets a copy, so that a dropped rule spoils no other run."""
    options.cache = tempfile.mkdtemp(prefix="mutation-cache-")
    for program in ("returned.c", "read.cpp"):
        subprocess.run([os.path.join(options.build, "tool", "symreal"), "generate", os.path.join(HERE, "Inputs", program), "--frozen=allow",
                        "-o", os.path.join(options.cache, "k.c")], env=dict(environment(""), XDG_CACHE_HOME=options.cache),
                       capture_output=True, check=True)


def net(options, rule, dropped):
    """What of the net notices, or nothing."""
    directory = tempfile.mkdtemp(prefix="mutation-")
    try:
        shutil.copy(os.path.join(HERE, "Inputs", rule.program), directory)
        shutil.copytree(options.cache, os.path.join(directory, "cache"))
        link = library(rule, directory)
        tool = os.path.join(options.build, "tool", "symreal")
        script = os.path.join(HERE, "Inputs", os.path.splitext(rule.program)[0] + ".sh")
        between = [["sh", script, tool]] if os.path.exists(script) else []
        for command in ([tool, "generate", rule.program, "-o", "k.c", *rule.options, *link, "--", *rule.flags], *between,
                        [tool, "verify", rule.program, "k.c", *link, "--", *rule.flags],
                        [tool, "verify", "--numeric", rule.program, "--", *rule.flags]):
            done = subprocess.run(command, cwd=directory, env=dict(environment(dropped), XDG_CACHE_HOME=os.path.join(directory, "cache")),
                                  capture_output=True, text=True, errors="replace", timeout=600)
            if options.verbose:
                print(done.stderr, end="")
            if done.returncode != 0:
                return f"{command[1]}: {reason(done)}"
        return ""
    finally:
        shutil.rmtree(directory)


def tests(options, rule, dropped):
    """The first test that fails, or nothing."""
    done = subprocess.run([sys.executable, options.lit, "-s", "-j1", "--max-failures=1", f"--filter={rule.tests}",
                           os.path.join(options.build, "tests")], env=environment(dropped), capture_output=True, text=True)
    if dropped:
        shutil.rmtree(os.path.join(options.build, "tests", "without-" + dropped), ignore_errors=True)
    if options.verbose:
        print(done.stdout, end="")
    if "Passed" not in done.stdout and "Failed" not in done.stdout:
        sys.exit(f"{rule.name}: no test is called {rule.tests}")
    failed = re.search(r"^ +symreal :: (\S+)", done.stdout, re.MULTILINE)
    return failed.group(1) if failed else ""


def as_it_is(options, rule, noticed, failed):
    """What is wrong with the row itself: nothing may be noticed where nothing is dropped, but what the rule is there to refuse."""
    refused = rule.refused if ": " in rule.refused or not rule.refused else f"generate: {rule.refused}"
    if (noticed or refused) and not options.tests:
        found = net(options, rule, "")
        if found != refused:
            return found or "nothing is refused"
    return tests(options, rule, "") if failed else ""


def execute(options, rule):
    noticed = "" if options.tests else net(options, rule, rule.name)
    failed = "" if options.net else tests(options, rule, rule.name)
    return rule, noticed, failed, "" if options.granted else as_it_is(options, rule, noticed, failed)


def main():
    options = arguments()
    options.build = os.path.abspath(options.build)
    wanted = set(filter(None, options.rules.split(",")))
    rules = [rule for rule in RULES if not wanted or rule.name in wanted]
    if not options.tests:
        warm_cache(options)
    by_net, by_tests, wrong = 0, 0, 0
    print("| Rule | What it does | The net | The tests |\n|---|---|---|---|")
    with ThreadPoolExecutor(options.jobs) as pool:
        for rule, noticed, failed, fault in pool.map(lambda one: execute(options, one), rules):
            by_net, by_tests, wrong = by_net + bool(noticed), by_tests + bool(failed), wrong + bool(fault)
            words = f"without the mutation: {fault}" if fault else f"{noticed or '-'} | {failed or '-'}"
            print(f"| {rule.name} | {rule.what} | {words} |", flush=True)
    if not options.tests:
        shutil.rmtree(options.cache)
    print(f"{len(rules)} rules, {by_net} noticed by the net, {by_tests} by the tests, {wrong} with a fault of their own")
    return 1 if wrong or (by_tests < len(rules) and not options.net) else 0


if __name__ == "__main__":
    sys.exit(main())
