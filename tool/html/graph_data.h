// The nodes of a graph and its timetable as JSON, in packed columns.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "engine/graph/graph.h"
#include "tool/analysis/timetable.h"
#include "tool/html/sources.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace symreal::tool {

// Live nodes without constants, renumbered from 0; an operand is twice the distance to an older node, or an odd number
// for a constant.
nlohmann::ordered_json node_data(Graph const &graph, Figures const &figures, Sources const &sources);

// Timetable by unit: distance from the end of the previous task, duration, node.
nlohmann::ordered_json timetable_data(Graph const &graph, ScheduleReport const &report,
                                      std::vector<NodeId> const &node_of_task);

} // namespace symreal::tool
