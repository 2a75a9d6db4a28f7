// Reads of arrays at symbolic indices.
#include "engine/graph/graph.h"
#include "engine/support/number.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/events.h"

#include <symreal/decisions.h>
#include <symreal/external.h>
#include <symreal/lookup.h>

#include <algorithm>

namespace symreal {

using trace::Pool;
using trace::session;

void symreal_declare_table(void const *pointer, std::size_t count) noexcept {
  session().externals.declare_extent(pointer, count);
}

std::size_t detail::declared_extent(void const *pointer) noexcept {
  return session().externals.declared_extent(pointer);
}

namespace {

// The index by the carried values. One outside of the table is reported: the original is undefined there. On a
// hypothetical path it may be anything.
std::size_t carried_index(char const *name, RealNumber index, std::size_t extent) {
  double const value = index.is_node() ? detail::needed_value(index) : index.plain();
  bool const is_inside = value > -1 && value < static_cast<double>(extent);
  if (!is_inside && !session().path.is_hypothetical())
    trace::report_here(DiagnosticId::index_outside, std::string("'") + name + "' has " + std::to_string(extent) +
                                                        " elements, and the index " + trace::describe(index) + " is " +
                                                        shortest(value));
  return table_index(value, extent);
}

// Under policy guard the recorded path includes that the index lies in the table; otherwise one outside reads the
// nearest element.
void require_within(RealNumber index, std::size_t extent) {
  if (decisions() != Decisions::guard || !index.is_node()) return;
  require(index >= RealNumber(0.0));
  require(index < RealNumber(static_cast<double>(extent)));
}

// The text of the source may be a macro's; a name is enough.
Table table_of(char const *name, RealNumber const *numbers, std::size_t rows, std::size_t columns) {
  Table table{name, {rows}, {}, {}};
  if (columns != 0) table.extents.push_back(columns);
  table.values.reserve(rows * std::max<std::size_t>(columns, 1));
  for (std::size_t k = 0; k < rows * std::max<std::size_t>(columns, 1); ++k) table.values.push_back(numbers[k].plain());
  return table;
}

} // namespace

RealNumber const detail::look_up(TableName table, void const *elements, std::size_t rows, std::size_t columns,
                                 RealNumber row, RealNumber column) noexcept {
  void const *caller = __builtin_return_address(0);
  char const *name = table.name;
  auto *numbers = static_cast<RealNumber const *>(elements);
  std::size_t const count = rows * std::max<std::size_t>(columns, 1);
  std::size_t at = carried_index(name, row, rows);
  if (columns != 0) at = at * columns + carried_index(name, column, columns);
  Pool &pool = session().pool;
  if (std::any_of(numbers, numbers + count, [](RealNumber number) { return number.is_node(); })) {
    // A table of expressions, not constants: the index is decided.
    if (row.is_node()) (void)convert_to_integer(row);
    if (columns != 0 && column.is_node()) (void)convert_to_integer(column);
    return numbers[at];
  }
  require_within(row, rows);
  if (columns != 0) require_within(column, columns);
  Op const op = columns == 0 ? Op::lookup : Op::lookup2;
  ++executed[static_cast<unsigned>(op)];
  NodeId const which =
      pool.node(static_cast<double>(session().externals.number(table_of(name, numbers, rows, columns))));
  NodeId const i = pool.node(row), j = columns == 0 ? no_node : pool.node(column);
  return pool.leaf(pool.nodes().operation(op, which, i, j), numbers[at].plain(), caller);
}

} // namespace symreal
