// Numbering of the tables and external functions that a recording refers to.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/trace/parts/parts.h"

#include <symreal/real_number.h>

#include <map>
#include <string>
#include <vector>

namespace symreal::trace {

class Externals {
public:
  explicit Externals(Pool &pool) : pool_(pool) {}

  void begin();
  // The number of a table with these elements, or of this function; added if new.
  std::size_t number(Table table);
  std::size_t number(External const &external);

  // Extent that a pragma declares for a pointer; 0 without one.
  void declare_extent(void const *pointer, std::size_t count) { extents_[pointer] = count; }
  std::size_t declared_extent(void const *pointer) const {
    auto const found = extents_.find(pointer);
    return found == extents_.end() ? 0 : found->second;
  }

  // The last call with an effect, which the next one is ordered after; 0 before the first.
  RealNumber last_effect() const { return last_effect_; }
  void set_last_effect(RealNumber call) { last_effect_ = call; }

  std::vector<Table> const &tables() const { return tables_; }
  std::vector<External> const &functions() const { return functions_; }

  // Adds all tables and functions to the graph.
  void end(Graph &graph);

private:
  Pool &pool_;
  std::vector<Table> tables_;
  std::vector<External> functions_;
  std::map<void const *, std::size_t> extents_;
  RealNumber last_effect_ = 0.0;
};

} // namespace symreal::trace
