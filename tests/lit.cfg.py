# What stands in RUN lines: %symreal the tool (what it generates is compiled as well), %tool the executable itself,
# %rewrite prints rewritten text, %dump that with what else there is (also the facts), %decide what becomes of facts, %same compares object code,
# %source the repository, %venv the programs of tests/requirements.txt, %inputs the example programs, %runtime_include the public headers, %runtime the directory of the runtime,
# %tools helper scripts, %version the tool's version, %cxx %cc %clang compilers.
import os
import platform
import shutil
import subprocess
import tempfile

import lit.formats

config.name = "symreal"
config.test_format = lit.formats.ShTest(execute_external=False)
config.suffixes = [".test", ".cpp", ".c", ".graph", ".txt", ".facts"]
# Unit tests are GoogleTest's, fuzzers are programs; a directory "Inputs" holds what tests read; the files of CMake and pip are no tests.
config.excludes = ["unit", "tools", "Inputs", "fuzzers", "CMakeLists.txt", "requirements.txt"]
config.test_source_root = os.path.join(config.source_dir, "tests")
# The rule that a build for the mutation test leaves out. Files that tests leave behind without it are not used again.
dropped = os.environ.get("SYMREAL_DROP_RULE")
config.test_exec_root = os.path.join(config.binary_dir, "tests", *(["without-" + dropped] if dropped else []))

# Leaks into foreign code are trapped there.
if platform.system() == "Linux" and platform.machine() == "x86_64":
    config.available_features.add("x86_64-linux")

    if any(line.startswith("flags") and " avx2 " in line and " fma " in line for line in open("/proc/cpuinfo")):
        config.available_features.add("avx2")

# The Python packages of tests/requirements.txt.
venv = os.path.join(config.source_dir, "build", "venv", "bin")
# What a language needs that not every machine has; a test that requires it is reported as unsupported without.
for program, feature in [("rustc", "rustc"), ("flang-new-19", "flang"), ("gfortran", "fortran"), ("javac", "java"), ("node", "javascript"), ("go", "go"),
                         ("dot", "graphviz"), ("gnuplot", "gnuplot"), ("octave-cli", "matlab"), ("mkoctfile", "mex"), ("cppcheck", "cppcheck"), ("chromium", "chromium"),
                         (venv + "/mathics", "mathematica"),
                         (venv + "/fmpy", "fmpy"), (venv + "/dask", "dask")]:
    if shutil.which(program):
        config.available_features.add(feature)
if os.path.exists(venv + "/python") and subprocess.run([venv + "/python", "-c", "import tree_sitter_julia"], capture_output=True).returncode == 0:
    config.available_features.add("julia-grammar")
if subprocess.run(["/usr/bin/python3", "-c", "import numpy"], capture_output=True).returncode == 0:
    config.available_features.add("python")

# scripts/test --all: what takes long and has a small setting, in full.
everything = bool(os.environ.get("SYMREAL_TEST_ALL"))
if everything:
    config.available_features.add("all")

config.substitutions += [
    (r"%symreal(?=-)", os.path.join(config.binary_dir, "tool", "symreal")),
    (r"%symreal\b", os.path.join(config.source_dir, "tests", "tools", "symreal")),
    (r"%tool\b", os.path.join(config.binary_dir, "tool", "symreal")),
    (r"%build\b", config.binary_dir),
    (r"%rewrite\b", os.path.join(config.binary_dir, "rewrite", "symreal-rewrite-dump") + " --text"),
    (r"%dump\b", os.path.join(config.binary_dir, "rewrite", "symreal-rewrite-dump")),
    (r"%decide\b", os.path.join(config.binary_dir, "rewrite", "symreal-rewrite-dump") + " --text --decide"),
    (r"%same\b", "python3 " + os.path.join(config.source_dir, "tests", "tools", "same_object.py") + (" --all " if everything else " ")
     + os.path.join(config.binary_dir, "rewrite", "symreal-rewrite-dump") + " "
     + os.path.join(config.binary_dir, "runtime", "include")),
    (r"%source\b", config.source_dir),
    (r"%venv\b", venv),
    (r"%inputs\b", os.path.join(config.source_dir, "inputs")),
    (r"%runtime_include\b", os.path.join(config.binary_dir, "runtime", "include")),
    (r"%runtime\b", os.path.join(config.source_dir, "runtime")),
    (r"%runtime_library\b", os.path.join(config.binary_dir, "runtime", "libsymreal_runtime.a")),
    (r"%library\b", os.path.join(config.binary_dir, "runtime", "libsymreal_generate.a")),
    (r"%tools\b", os.path.join(config.source_dir, "tests", "tools")),
    (r"%version\b", config.version),
    (r"%llvm_tools\b", os.path.join(config.llvm_tools, "bin")),
    (r"%clang\b", "clang-19"),
    (r"%cxx\b", "g++"),
    (r"%cc\b", "gcc"),
]
# Objects are kept from test to test, but never those of another build of the tool.
config.environment["XDG_CACHE_HOME"] = os.path.join(config.test_exec_root, "cache")
# A run of the tool makes and removes hundreds of small files, which takes less time in memory than on a disk. lit makes the directory.
memory = "/dev/shm"
if os.access(memory, os.W_OK):
    room = os.statvfs(memory)
    if room.f_bavail * room.f_frsize > 4 << 30 and not room.f_flag & os.ST_NOEXEC:
        tempfile.tempdir = memory
# A busy machine makes a run long, and tests compare what it prints.
config.environment["SYMREAL_PROGRESS"] = "0"
config.environment["SYMREAL_UNDER_TEST"] = os.path.join(config.binary_dir, "tool", "symreal")
# FileCheck and count; `not` is built into lit. At the end of PATH: the compilers are the system's.
config.environment["PATH"] = os.pathsep.join([os.environ["PATH"], os.path.join(config.llvm_tools, "bin"), venv])
if dropped:
    config.environment["SYMREAL_DROP_RULE"] = dropped
