// The blocks of a kernel, for the user: text, JSON, a table of operations; and whether threads pay.
#pragma once

#include "engine/analysis/threads/advice.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>

namespace symreal::tool {

struct BlocksReport {
  Graph const *graph;
  Costs const *costs;
  KernelBlocks const *kernel;
  std::optional<Advice> advice;
};
// With advice where the costs know threads, and there are two blocks at least.
BlocksReport blocks_report(Graph const &graph, Costs const &costs, KernelBlocks const &kernel);

void print_blocks(std::ostream &out, BlocksReport const &report);
// In words.
void print_advice(std::ostream &out, BlocksReport const &report);
nlohmann::ordered_json to_json(BlocksReport const &report);
// A line per operation: its node in the graph's text, its block.
std::string blocks_csv(Graph const &graph, KernelBlocks const &kernel);

} // namespace symreal::tool
