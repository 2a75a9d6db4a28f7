// What a page shows, as JSON: each function is a part of it.
#pragma once

#include "engine/graph/graph.h"
#include "tool/html/sources.h"
#include "tool/scheduling/timetable_output.h"

#include "engine/analysis/figures/figures.h"
#include "engine/ops/floating_point.h"

#include <nlohmann/json.hpp>

namespace symreal::tool {

using Json = nlohmann::ordered_json;

// {"step": 1, "from_inputs": [...], "from_outputs": [...], "levelled": [...]}: of `step` units of time the highest.
Json profile_data(Figures const &figures);

// [{"name": "arm.cpp", "text": "...", "functions": [["dot", 3, 9], ...]}, ...]; text null: it is gone.
Json source_data(Sources const &sources);

// {"name": "arm.c", "text": "...", "origins": [[first, last, [[file, line], ...]], ...]}; too much code: {"lines": n}.
Json code_data(Graph const &graph, FloatingPoint mode, Sources const &sources);

// The nodes that something needs, constants apart, in packed columns (packed.h). They are numbered anew from 0; an
// operand is twice the distance to an older node, or an odd number for a constant.
Json node_data(Graph const &graph, Figures const &figures, Sources const &sources);

// The timetable by unit, in packed columns: the distance from the end of the task before, the duration, the node.
Json timetable_data(Graph const &graph, ScheduleReport const &report, std::vector<NodeId> const &node_of_task);

// Per node of the graph: its number in node_data, or no_node.
std::vector<NodeId> shown_numbers(Graph const &graph);

} // namespace symreal::tool
