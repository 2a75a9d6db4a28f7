#include "engine/emit/c/parts.h"
#include "engine/emit/languages/languages.h"

namespace symreal {

static constexpr Companion beside[] = {{".h", c_header},
                                       {"_main.c", c_mainline, "mainline"},
                                       {"_mex.c", c_mex, "mex", true, true},
                                       {"_sfun.c", c_simulink, "simulink", true, true}};

Language language_c() {
  Language c;
  c.names = c_names;
  c.comment = {"/* ", "   ", " */"};
  c.lines = {.width = 100, .least = 60, .continuation = ""};
  c.numbers = {"NAN", "-NAN", "INFINITY", "-INFINITY"};
  c.number = {"double", "0.0"};
  c.truth = {"bool", "false"};
  c.wide = {"uint64_t", "0"};
  c.single = {.number = {"float", "0.0f"},
              .numbers = {"NAN", "-NAN", "INFINITY", "-INFINITY", "e", "f", "", "f"},
              .call_suffix = "f"};
  c.expressions = {
      .element = "$array[$index]",
      .yes = "true",
      .has_plus = true,
      .small_integer = "${value}u",
      .large_integer = "UINT64_C($value)",
      .kept_integer = "kept_integer(&$element)",
      .hidden = "at_run($x)",
      .table_index = "table_index($index, $extent)",
  };
  c.statements = {
      .variable = "$type $name = $value;",
      .constant = "$type const $name = $value;",
      .set = "$name = $value;",
      .keep_integer = "keep_integer(&$element, $value);",
      .array = "$real $name[$count];",
      .zero_array = "$real $name[$count] = {0.0$suffix};",
      .open = "if ($condition) {",
      .otherwise = "} else {",
      .close = "}",
      .check = "if ($condition) return $number;",
      .value_check = "if (!isfinite($name)) report_value($name, \"$text\");",
      .value_check_begin = "all_finite = 1;",
  };
  c.functions = {
      .head = "$result $name($parameters) {",
      .local_head = "${apart}${beside}static $result $name($parameters) {",
      .end = "}",
      .apart = "SYMREAL_APART ",
      .beside = "SYMREAL_SIDE_BY_SIDE ",
      .no_result = "void",
      .status = "int",
      .input = "$real const *$name",
      .output = "$real *$name",
      // In parts, restrict says that stores change no input, so compilers read each once and pair its sin and cos.
      .local_output = "$real *restrict $name",
      .unused = "(void)$name;",
      .success = "return 0;",
      .failed = "int failed = 0;",
      .call = "$name($arguments);",
      .checked_call = "failed = $name($arguments);\nif (failed != 0) return failed;",
      .parts_store = true,
  };
  c.parallel = {
      .stage_begin = "#pragma omp parallel sections num_threads($threads)\n  {\n",
      .part_begin = "#pragma omp section\n    {\n",
      .part_end = "    }\n",
      .stage_end = "  }\n",
      .indent = 6,
  };
  c.loops = {
      .begin = "for (int $index = 0; $index < $count; ++$index) {",
      .end = "}",
      .counter = "int $index = 0;",
      .count = "++$index;",
      .row = "$real const *const $name = $table + $index;",
      .stored_row = "$real *const $name = $table + $index;",
      .element_table = "static unsigned const $name[$count] = {",
      .table_end = "};",
      .below_diagonal = "  /* A symmetric matrix: one half is the other. */\n"
                        "  for (int first = 0; first < $rows; first += 8) {\n"
                        "    int const end = first + 8 < $rows ? first + 8 : $rows;\n"
                        "    for (int row = first; row < end; ++row)\n"
                        "      for (int column = first; column < row; ++column) $copy\n"
                        "    for (int row = end; row < $rows; ++row)\n"
                        "      for (int column = first; column < first + 8; ++column) $copy\n"
                        "  }\n",
  };
  c.vectors = {
      .begin = "#if defined(SYMREAL_VECTORS)\n",
      .otherwise = "#else\n",
      .end = "#endif\n",
      .type = "${real}_$width",
      .load = "load_$width($place)",
      .store = "store_$width($place, $value);",
      .build = "(${real}_$width){$values}",
      .shuffle = "__builtin_shufflevector($x, $y, $lanes)",
      .lane = "$name[$lane]",
  };
  c.angles = {
      .call = "sines_and_cosines($count, $angles, $sine, $cosine);",
      .from = "$array + $first",
      .begin = "$real const $name[$count] = {",
      .end = "};",
      .helper = c_sines_and_cosines,
  };
  c.tables = {
      .begin = "static $real const $name[$count] = {",
      .end = "};",
      .index_helper = "/* An index outside of its table reads the nearest element. */\n"
                      "static int table_index($real index, int extent) {\n"
                      "  if (!(index > 0.0$suffix)) return 0;\n"
                      "  return index < ($real)extent ? (int)index : extent - 1;\n"
                      "}\n\n",
  };
  c.externals = {.declarations = c_external_declarations, .call = c_call};
  c.files = {
      .extension = ".c",
      .kept_when = ", when compiled with\n-ffp-contract=off -fno-tree-slp-vectorize$pow and without -ffast-math",
      .pow_flag = " -fno-builtin-pow",
      .fast_when = " Any compiler flags.",
      .begin = c_begin,
      .integer_functions = c_integer_functions,
      .hide_helper =
          "/* An argument that is constant on some path: a compiler would evaluate the call there, and round "
          "otherwise\n   than the library. */\n"
          "static $real at_run($real x) {\n"
          "  $real volatile const kept = x;\n"
          "  return kept;\n"
          "}\n\n",
      .end = c_end,
      .companions = beside,
  };
  return c;
}

} // namespace symreal
