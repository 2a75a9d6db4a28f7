# For the scripts beside it: same_runs BASE "PROGRAMS" [INPUTS]... runs BASE.run_c and each BASE.PROGRAM on every list of
# inputs, and prints what the first prints. Fails unless all print the same bits and end with the same status.
same_runs() {
  base=$1
  programs=$2
  shift 2
  [ "$#" -ne 0 ] || set -- ""
  for inputs in "$@"; do
    status=0
    "$base.run_c" $inputs > "$base.out_c" 2>&1 || status=$?
    for program in $programs; do
      status_of_run=0
      "$base.$program" $inputs > "$base.out" 2>&1 || status_of_run=$?
      [ "$status" = "$status_of_run" ]
      diff "$base.out_c" "$base.out"
    done
    cat "$base.out_c"
  done
}
