"""Commands within limits, and a memory of what they made: build/bench/peers keeps it by a hash of all that went into it."""
import hashlib
import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile

WORK = pathlib.Path("build/bench/peers")
MEMORY = 6 << 30


class Missing(Exception):
    """Why something is not there."""


def run(words, seconds=600, doing="", **options):
    """Standard output and error of a command, and what it took: seconds of a processor, the most memory in bytes.
    Missing where a process of it wants more than so many seconds of a processor or too much memory."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as error:
        process = subprocess.Popen([str(word) for word in words], stdout=out, stderr=error, preexec_fn=limit, **options)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
        for file in (out, error):
            file.seek(0)
        said, complaint = out.read(), error.read().decode(errors="replace")
    took = usage.ru_utime + usage.ru_stime
    is_cut_off = os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU
    ended_by_limit = any(words in complaint for words in ("CPU time limit exceeded", "unable to execute command: Killed"))
    if status and (is_cut_off or took > seconds - 1 or ended_by_limit):  # of a compiler's driver, or of what it runs
        raise Missing(f"{doing} takes more than {seconds} s".strip())
    if status and any(word in complaint for word in ("bad_alloc", "MemoryError", "out of memory", "annot allocate memory")):
        raise Missing(f"{doing} takes more than {MEMORY >> 30} GB".strip())
    if status:
        raise SystemExit(f"bench: {' '.join(map(str, words))}\n{complaint[-3000:]}")
    return said, complaint, {"processor": took, "memory": usage.ru_maxrss * 1024}


def digest(*parts):
    return hashlib.sha256("\0".join(map(str, parts)).encode()).hexdigest()[:24]


def remembered(key, make):
    """make()'s result, from a file where there is one of this key. A reason why it is missing is remembered as well."""
    path = WORK / "made" / f"{key}.json"
    if path.exists():
        made = json.loads(path.read_text())
    else:
        try:
            made = {"result": make()}
        except Missing as reason:
            made = {"missing": str(reason)}
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(made))
    if "missing" in made:
        raise Missing(made["missing"])
    return made["result"]
