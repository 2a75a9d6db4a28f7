// Report on the blocks of a kernel: text, JSON, a table of operations; and advice on threads.
#pragma once

#include "engine/analysis/blocks/advice.h"

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
// Makes the report, with advice if the costs cover threads and there are at least two blocks.
BlocksReport blocks_report(Graph const &graph, Costs const &costs, KernelBlocks const &kernel);

void print_blocks(std::ostream &out, BlocksReport const &report);
// Prints the advice in words.
void print_advice(std::ostream &out, BlocksReport const &report);
nlohmann::ordered_json to_json(BlocksReport const &report);
// One line per operation: its node in the graph's text, its block.
std::string blocks_csv(Graph const &graph, KernelBlocks const &kernel);

} // namespace symreal::tool
