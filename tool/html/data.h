// Data of a page as JSON; each function gives one part.
#pragma once

#include "engine/graph/graph.h"
#include "tool/html/sources.h"
#include "tool/scheduling/timetable_output.h"

#include "engine/analysis/figures/figures.h"
#include "engine/ops/floating_point.h"

#include <nlohmann/json.hpp>

namespace symreal::tool {

using Json = nlohmann::ordered_json;

// {"step": 1, "from_inputs": [...], "from_outputs": [...], "levelled": [...]}: maximum of each `step` units of time.
Json profile_data(Figures const &figures);

// [{"name": "arm.cpp", "text": "...", "functions": [["dot", 3, 9], ...]}, ...]; null text: the file is missing.
Json source_data(Sources const &sources);

// {"name": "arm.c", "text": "...", "origins": [[first, last, [[file, line], ...]], ...]}; for long code: {"nodes": n}.
Json code_data(Graph const &graph, FloatingPoint mode, Sources const &sources);

// Live nodes without constants, in packed columns (packed.h), renumbered from 0; an operand is twice the distance to an
// older node, or an odd number for a constant.
Json node_data(Graph const &graph, Figures const &figures, Sources const &sources);

// Timetable by unit, in packed columns: distance from the end of the previous task, duration, node.
Json timetable_data(Graph const &graph, ScheduleReport const &report, std::vector<NodeId> const &node_of_task);

// Number in node_data of each node of the graph, or no_node.
std::vector<NodeId> shown_numbers(Graph const &graph);

} // namespace symreal::tool
