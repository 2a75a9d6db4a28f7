#include "engine/emit/print/emission.h"

namespace symreal {

void Uses::add(Uses const &other) {
  for (std::size_t op = 0; op < op_count; ++op) {
    operations[op] = operations[op] || other.operations[op];
    spelled[op] = spelled[op] || other.spelled[op];
  }
  integer_functions.insert(other.integer_functions.begin(), other.integer_functions.end());
  tables.insert(other.tables.begin(), other.tables.end());
  externals.insert(other.externals.begin(), other.externals.end());
  kept_integer = kept_integer || other.kept_integer;
  keep_integer = keep_integer || other.keep_integer;
  truths = truths || other.truths;
  hidden = hidden || other.hidden;
  value_checks = value_checks || other.value_checks;
  apart = apart || other.apart;
  side_by_side = side_by_side || other.side_by_side;
  not_finite = not_finite || other.not_finite;
}

} // namespace symreal
