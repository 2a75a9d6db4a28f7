/* Long patterns of C, for c.toml. Marks: language_file.h. */

/* @text loops.below_diagonal */
  /* A symmetric matrix: one half is the other. */
  for (int first = 0; first < $rows; first += 8) {
    int const end = first + 8 < $rows ? first + 8 : $rows;
    for (int row = first; row < end; ++row)
      for (int column = first; column < row; ++column) $copy
    for (int row = end; row < $rows; ++row)
      for (int column = first; column < first + 8; ++column) $copy
  }

/* @text tables.index_helper */
/* An index outside of its table reads the nearest element. */
static int table_index($real index, int extent) {
  if (!(index > 0.0$suffix)) return 0;
  return index < ($real)extent ? (int)index : extent - 1;
}

/* @text files.hide_helper */
/* An argument that is constant on some path: a compiler would evaluate the call there, and round otherwise
   than the library. */
static $real at_run($real x) {
  $real volatile const kept = x;
  return kept;
}
