#include "tool/options/cost_option.h"

#include "engine/support/files.h"

namespace symreal::tool {

Costs costs_named(std::string const &cost) {
  if (cost == "unit") return unit_cost_model();
  if (cost == "table") return table_cost_model();
  return read_costs(read_file(cost), cost);
}

} // namespace symreal::tool
