#include "runtime/trace/nodes/externals.h"

#include "engine/support/number.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/nodes/pool.h"

#include <algorithm>

namespace symreal::trace {

void Externals::begin() {
  tables_.clear();
  functions_.clear();
  extents_.clear();
  last_effect_ = 0.0;
}

std::size_t Externals::number(Table table) {
  auto found = std::find_if(tables_.begin(), tables_.end(), [&](Table const &known) {
    return known.name == table.name && known.extents == table.extents && all_same_bits(known.values, table.values);
  });
  if (found != tables_.end()) return static_cast<std::size_t>(found - tables_.begin());
  memory::OwnWork const own;
  tables_.push_back(std::move(table));
  return tables_.size() - 1;
}

std::size_t Externals::number(External const &external) {
  auto found = std::find_if(functions_.begin(), functions_.end(), [&](External const &known) {
    return known.name == external.name && known.pure == external.pure && known.returned == external.returned &&
           known.parameters == external.parameters && known.derivatives == external.derivatives;
  });
  if (found != functions_.end()) return static_cast<std::size_t>(found - functions_.begin());
  memory::OwnWork const own;
  functions_.push_back(external);
  return functions_.size() - 1;
}

void Externals::end(Graph &graph) {
  graph.tables = std::move(tables_);
  graph.externals = std::move(functions_);
  if (last_effect_.is_node()) graph.last_effect = pool_.node(last_effect_);
  begin();
}

} // namespace symreal::trace
