#!/bin/sh
# same_in_rust.sh BASE [INPUTS]...: compiles BASE.c and BASE.rs with their mainlines, all warnings of rustc as errors, with
# and without optimisation, and runs each on every list of inputs. Fails unless all print the same bits.
set -e
. "$(dirname "$0")/same_runs.sh"
base=$1
shift
gcc -std=c99 -O1 -ffp-contract=off -fno-builtin "$base.c" "${base}_main.c" -lm -o "$base.run_c"
for level in 0 3; do
  rustc --edition 2021 -D warnings -C opt-level=$level "${base}_main.rs" -o "$base.run_$level"
done
same_runs "$base" "run_0 run_3" "$@"
