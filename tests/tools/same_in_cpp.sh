#!/bin/sh
# same_in_cpp.sh BASE "LIBRARIES" [INPUTS]...: compiles BASE.c and BASE.cpp with their mainlines, C++ by two compilers and
# standards with all warnings as errors, and runs each on every list of inputs. Fails unless all print the same bits.
set -e
. "$(dirname "$0")/same_runs.sh"
base=$1
libraries=$2
shift 2
warnings="-Wall -Wextra -Wconversion -Werror -O1 -ffp-contract=off"
gcc -std=c99 -pedantic $warnings "$base.c" "${base}_main.c" $libraries -lm -o "$base.run_c"
g++ -std=c++17 $warnings "$base.cpp" "${base}_main.cpp" $libraries -lm -o "$base.run_17"
clang++-19 -std=c++20 $warnings "$base.cpp" "${base}_main.cpp" $libraries -lm -o "$base.run_20"
same_runs "$base" "run_17 run_20" "$@"
