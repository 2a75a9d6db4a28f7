// The three plots of a graph, side by side: operations under way if all begin early, late, or levelled.
#pragma once

#include "engine/analysis/figures/figures.h"

#include <string>

namespace symreal::tool {

// A script for Gnuplot that writes `image`; its ending, .svg or .png, says how. Throws bad_option for another one.
std::string plot_script(Graph const &graph, Costs const &costs, Figures const &figures, std::string const &image);

} // namespace symreal::tool
