// Recording of a family of programs, and its figures by size: runs the stages of `generate` up to the optimised graph,
// one size after the other.
#pragma once

#include "engine/analysis/figures/figures.h"
#include "program/record/front.h"
#include "tool/report/console.h"

#include <functional>
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

struct SweepRequest {
  SweepSizes sizes;
  bool as_argument = false; // the size is the program's last argument; false: a macro of the sources
  // Front request with these additional compiler flags.
  std::function<program::FrontRequest(std::vector<std::string> const &flags)> front;
  std::vector<rewrite::ConfiguredText> calls;
};

// Calls `take` with the recorded graph of each size. False after an error was reported. Throws sweep_differs.
bool record_sweep(SweepRequest const &request, Console &console, std::function<void(long size, Graph)> const &take);

struct SweepMember {
  long size;
  std::vector<double> figures; // in the order of the table's columns
};
SweepMember sweep_member(long size, Graph const &graph, Costs const &costs, Figures const &figures);

void print_sweep(std::ostream &out, std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                 std::vector<SweepMember> const &members);
nlohmann::ordered_json to_json(std::string const &kernel, SweepSizes const &sizes, Costs const &costs,
                               std::vector<SweepMember> const &members);
std::string sweep_csv(SweepSizes const &sizes, std::vector<SweepMember> const &members);

} // namespace symreal::tool
