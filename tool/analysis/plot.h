// Plots of a graph, side by side: operations under way if all begin early, late, or levelled.
#pragma once

#include "engine/analysis/figures/figures.h"

#include <string>

namespace symreal::tool {

// Gnuplot script that writes `image`, as SVG or PNG by its extension. Throws bad_option for another one.
std::string plot_script(Graph const &graph, Costs const &costs, Figures const &figures, std::string const &image);

} // namespace symreal::tool
