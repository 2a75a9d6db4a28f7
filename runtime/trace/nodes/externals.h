// The tables and external functions that a recording refers to, by number.
#pragma once

#include "engine/graph/graph.h"

#include <symreal/real_number.h>

#include <map>
#include <string>
#include <vector>

namespace symreal::trace {

class Externals {
public:
  static Externals &current(); // one per thread

  void begin();
  // The number of a table with these elements, or of this function: known, or new.
  std::size_t number(Table table);
  std::size_t number(External const &external);

  // What a pragma says of a pointer; 0 where none does.
  void declare_extent(void const *pointer, std::size_t count) { extents_[pointer] = count; }
  std::size_t declared_extent(void const *pointer) const {
    auto const found = extents_.find(pointer);
    return found == extents_.end() ? 0 : found->second;
  }

  // A call in order follows the one before it; 0 before the first.
  RealNumber last_effect() const { return last_effect_; }
  void set_last_effect(RealNumber call) { last_effect_ = call; }

  std::vector<Table> const &tables() const { return tables_; }
  std::vector<External> const &functions() const { return functions_; }

  // Adds all to the graph.
  void end(Graph &graph);

private:
  std::vector<Table> tables_;
  std::vector<External> functions_;
  std::map<void const *, std::size_t> extents_;
  RealNumber last_effect_ = 0.0;
};

} // namespace symreal::trace
