// Region table: the regions of a finished function body, as the emitters print them.
#pragma once

#include "engine/plan/schedule/regions.h"

#include <vector>

namespace symreal {

struct RegionTable {
  NodeId node_count = 0;
  std::vector<std::vector<Literal>> regions = {{}}; // by id, the outermost literal first; empty for `everywhere`
  std::vector<std::vector<RegionId>> gates = {};    // by number: its alternatives; empty: 1 where it is computed

  std::vector<Literal> const &literals(RegionId region) const { return regions[region]; }
  bool is_gate(NodeId condition) const { return condition >= node_count; }
  std::vector<RegionId> const &alternatives(NodeId gate) const { return gates[gate - node_count]; }
  std::size_t value_count() const { return node_count + gates.size(); } // number of nodes and gates
};

// Table of the regions of these statements and of the alternatives of gates; renumbers the ids in `region`.
RegionTable tabulate(Regions const &regions, std::size_t node_count, std::vector<RegionId> &region);

} // namespace symreal
