#include "tool/analysis/blocks_report.h"

#include "engine/graph/graph_text.h"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <nlohmann/json.hpp>

namespace symreal::tool {

namespace {

using Json = nlohmann::ordered_json;

std::string amount(KernelBlocks const &kernel, Time time) {
  return kernel.scale == 1 ? std::to_string(time) : fmt::format("{:.1f}", kernel.in_unit(time));
}

Json to_json(Advice const &advice) {
  return {{"threads", advice.threads},
          {"one_core", advice.one_core},
          {"levels", advice.levels},
          {"barrier", advice.barrier},
          {"by_levels", advice.by_levels},
          {"level_width", advice.level_width},
          {"width_to_pay", advice.width_to_pay},
          {"hand_over", advice.hand_over},
          {"hand_overs", advice.hand_overs},
          {"by_blocks", advice.by_blocks},
          {"in_order", advice.in_order},
          {"time_to_pay", advice.time_to_pay},
          {"pays", advice.pays()},
          {"batch_rate", advice.batch_rate},
          {"batch_to_pay", advice.batch_to_pay}};
}

} // namespace

BlocksReport blocks_report(Graph const &graph, Costs const &costs, KernelBlocks const &kernel) {
  BlocksReport result{&graph, &costs, &kernel, {}};
  if (costs.threads && costs.threads->is_measured() && kernel.blocks.count > 1)
    result.advice = advise(graph, costs, kernel);
  return result;
}

void print_blocks(std::ostream &out, BlocksReport const &report) {
  constexpr std::uint32_t most = 40;
  KernelBlocks const &kernel = *report.kernel;
  BlockFigures const &figures = kernel.figures;
  fmt::print(out, "kernel {}: {} operations, {} block{}, costs: {}, work in {}\n", report.graph->kernel, kernel.count,
             kernel.blocks.count, kernel.blocks.count == 1 ? "" : "s", report.costs->name, report.costs->time_unit);
  fmt::print(out, "  {:<18}{:>14}{:>14}\n", "block", "operations", "work");
  for (BlockId block = 0; block < kernel.blocks.count && block < most; ++block)
    fmt::print(out, "  {:<18}{:>14}{:>14}\n", block, figures.operations[block], amount(kernel, figures.work[block]));
  if (kernel.blocks.count > most)
    fmt::print(out, "  {:<18}{} further blocks; --json has all\n", "...", kernel.blocks.count - most);
  fmt::print(out, "  {:<18}{:>14.2f}   the largest work against the mean\n", "balance", figures.balance);
  fmt::print(out, "  {:<18}{:>14}   dependencies from block to block\n", "edge cut", figures.cut);
  fmt::print(out, "  {:<18}{:>14}   values that cross, each once for every block that receives it\n", "volume",
             figures.volume);
  fmt::print(out, "  {:<18}{:>14}   one after the other, on the path that has most\n", "hand-overs",
             figures.hand_overs);
  if (figures.depth)
    fmt::print(out, "  {:<18}{:>14}   blocks one after the other\n", "depth", *figures.depth);
  else
    fmt::print(out, "  {:<18}{:>14}   there are blocks that wait for each other in turn\n", "depth", "none");
  fmt::print(out, "  {:<18}{:>14}   independent of each other; the largest has {} operations\n", "components",
             kernel.components.count(), kernel.components.largest());
}

Json to_json(BlocksReport const &report) {
  KernelBlocks const &kernel = *report.kernel;
  BlockFigures const &figures = kernel.figures;
  Json json = {{"kernel", report.graph->kernel},
               {"operations", kernel.count},
               {"costs", report.costs->name},
               {"time_unit", report.costs->time_unit}};
  for (BlockId block = 0; block < kernel.blocks.count; ++block)
    json["blocks"].push_back(
        {{"operations", figures.operations[block]}, {"work", kernel.in_unit(figures.work[block])}});
  json["balance"] = figures.balance;
  json["cut"] = figures.cut;
  json["volume"] = figures.volume;
  json["hand_overs"] = figures.hand_overs;
  json["depth"] = figures.depth ? Json(*figures.depth) : Json(nullptr);
  json["components"] = Json::array();
  for (std::size_t const tasks : kernel.components.tasks)
    if (tasks != 0) json["components"].push_back(tasks);
  if (report.advice) json["threads"] = to_json(*report.advice);
  return json;
}

std::string blocks_csv(Graph const &graph, KernelBlocks const &kernel) {
  std::vector<NodeId> const numbers = line_numbers(graph);
  std::string text = "node,block\n";
  for (TaskId task = 0; task < kernel.operations.node.size(); ++task)
    text += fmt::format("%{},{}\n", numbers[kernel.operations.node[task]], kernel.blocks[task]);
  return text;
}

} // namespace symreal::tool
