#include "engine/plan/schedule/region_table.h"

#include <unordered_map>

namespace symreal {

RegionTable tabulate(Regions const &regions, std::size_t node_count, std::vector<RegionId> &region) {
  RegionTable table{static_cast<NodeId>(node_count)};
  std::unordered_map<RegionId, RegionId> number = {{everywhere, everywhere}};
  auto const renumber = [&](RegionId id) {
    auto const [found, is_new] = number.try_emplace(id, static_cast<RegionId>(table.regions.size()));
    if (is_new) table.regions.push_back(regions.literals(id));
    return found->second;
  };
  for (RegionId &id : region) id = renumber(id);
  for (std::size_t gate = node_count; gate < regions.value_count(); ++gate) {
    std::vector<RegionId> &alternatives = table.gates.emplace_back();
    for (RegionId alternative : regions.alternatives(static_cast<NodeId>(gate)))
      alternatives.push_back(renumber(alternative));
  }
  return table;
}

} // namespace symreal
