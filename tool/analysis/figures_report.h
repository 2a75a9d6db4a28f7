// Report on the figures of a graph: text, JSON, tables of numbers.
#pragma once

#include "engine/analysis/figures/figures.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>

namespace symreal::tool {

// Amount in the costs' unit: "33", "4.5".
std::string amount(Costs const &costs, Time time);
// Nanoseconds as three digits in a suitable unit.
std::string time_text(double nanoseconds);

void print_figures(std::ostream &out, Graph const &graph, Costs const &costs, Figures const &figures);
nlohmann::ordered_json to_json(Graph const &graph, Costs const &costs, Figures const &figures);

// One line per unit of time: operations under way if all begin early, late, or levelled.
std::string profile_csv(Costs const &costs, Figures const &figures);
// One line per operation: its node in the graph's text, its levels and its place.
std::string operations_csv(Graph const &graph, Costs const &costs, Figures const &figures);

} // namespace symreal::tool
