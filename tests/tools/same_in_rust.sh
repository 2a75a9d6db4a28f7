#!/bin/sh
# same_in_rust.sh BASE [INPUTS]...: compiles BASE.c and BASE.rs with their mainlines, all warnings of rustc as errors, with
# and without optimisation, and runs each on every list of inputs. Fails unless all print the same bits.
set -e
base=$1
shift
gcc -std=c99 -O1 -ffp-contract=off -fno-builtin "$base.c" "${base}_main.c" -lm -o "$base.run_c"
for level in 0 3; do
  rustc --edition 2021 -D warnings -C opt-level=$level "${base}_main.rs" -o "$base.run_$level"
done
[ "$#" -ne 0 ] || set -- ""
for inputs in "$@"; do
  status=0
  "$base.run_c" $inputs > "$base.out_c" 2>&1 || status=$?
  for level in 0 3; do
    status_of_run=0
    "$base.run_$level" $inputs > "$base.out" 2>&1 || status_of_run=$?
    [ "$status" = "$status_of_run" ]
    diff "$base.out_c" "$base.out"
  done
  cat "$base.out_c"
done
