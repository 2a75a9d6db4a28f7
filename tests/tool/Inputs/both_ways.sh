#!/bin/sh
# both_ways.sh TOOL SOURCE GENERATED DIRECTORY CASE...: verifies each case with forks of several runs and with a fork each,
# and tells the exit status, which is that of both, and whether the former were few. Fails where the two say other things.
tool=$1 source=$2 generated=$3 directory=$4
shift 4
rm -rf "$directory" && mkdir -p "$directory"
samples=100
for case in "$@"; do
  for way in "" --fork-each; do
    "$tool" verify "$source" "$generated" --samples=$samples --min-samples=5 --timeout 2 $way --run-args "$directory/forks$way" \
      --link -pthread -- "-D$case" > "$directory/said$way" 2>&1
    echo "status $?" >> "$directory/said$way"
    [ -e "$directory/forks$way" ] || : > "$directory/forks$way"
  done
  if ! cmp -s "$directory/said" "$directory/said--fork-each"; then
    echo "$case: differs"
    diff "$directory/said" "$directory/said--fork-each"
    exit 1
  fi
  several=$(wc -c < "$directory/forks") each=$(wc -c < "$directory/forks--fork-each")
  count=many
  # The rewritten program, which leaves nothing, has one fork for each sample less.
  [ $((several + 3 * samples / 2)) -lt "$each" ] && count=few
  echo "$case: $(tail -n 1 "$directory/said"), $count forks: $several, $each"
  rm -f "$directory/forks" "$directory/forks--fork-each"
done
