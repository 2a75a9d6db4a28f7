// Figures of a family of programs by size, and their growth.
#pragma once

#include "engine/analysis/figures/figures.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace symreal::tool {

// Name and values of the size, ascending: "N=1..16", "N=1..64:4", "N=1,2,4,8".
struct SweepSizes {
  std::string name;
  std::vector<long> values;
};
// Throws bad_option.
SweepSizes parse_sweep(std::string const &text);

struct SweepMember {
  long size;
  std::vector<double> figures; // in the order of figure_names
};
std::vector<std::string_view> figure_names();
SweepMember sweep_member(long size, Graph const &graph, Costs const &costs, Figures const &figures);

void print_sweep(std::ostream &out, std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                 std::vector<SweepMember> const &members);
nlohmann::ordered_json to_json(std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                               std::vector<SweepMember> const &members);
std::string sweep_csv(SweepSizes const &sizes, std::vector<SweepMember> const &members);

} // namespace symreal::tool
