#include "engine/plan/lanes/lanes.h"

#include "engine/plan/lanes/check.h"
#include "engine/plan/lanes/search.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

// Limit on operations: the search takes superlinear time, and so do compilers on one function.
constexpr std::size_t most_operations = 3000;

} // namespace

std::string obstacle_to_lanes(Plan const &plan) {
  std::vector<char> const live = live_nodes(*plan.graph);
  std::size_t operations = 0;
  for (NodeId id = 0; id < plan.graph->nodes.size(); ++id) {
    Op const op = plan.graph->nodes[id].op;
    if (!live[id] || is_leaf(op) || plan.element(id)) continue;
    if (is_call(op)) return "it calls external functions";
    ++operations;
  }
  if (operations > most_operations)
    return fmt::format("it has {} operations, more than {}", operations, most_operations);
  if (std::ranges::any_of(plan.compute().region, [](RegionId region) { return region != everywhere; }))
    return "some of it is computed under conditions only";
  return {};
}

Laned laned(Plan const &plan, std::size_t width) {
  if (std::string why = obstacle_to_lanes(plan); !why.empty()) return {{}, std::move(why)};
  lanes::ScalarFunction const function(plan, width);
  lanes::LaneFunction found = lanes::lane_function(function, lanes::search(function));
  if (found.in_lanes == 0) return {{}, "no operations are worth computing side by side"};
  internal_check(lanes::find_difference(function, found).empty());
  return {std::move(found), {}};
}

std::string describe(lanes::LaneFunction const &function) {
  return fmt::format("compute: {} of {} operations in vectors of {}", function.in_lanes, function.operations,
                     function.width);
}

} // namespace symreal
