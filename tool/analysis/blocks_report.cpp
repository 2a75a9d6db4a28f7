#include "tool/analysis/blocks_report.h"

#include "engine/graph/graph_text.h"
#include "tool/analysis/figures_report.h"

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

void print_times(std::ostream &out, Advice const &advice) {
  auto const row = [&](std::string const &name, double nanoseconds, std::string const &why) {
    fmt::print(out, "  {:<18}{:>14}   {}\n", name, time_text(nanoseconds), why);
  };
  fmt::print(out, "by these costs one evaluation takes at least\n");
  row("on one core", advice.one_core, "the larger of work and longest path");
  row("by levels", advice.by_levels,
      fmt::format("{} levels, a barrier of {} each", advice.levels, time_text(advice.barrier)));
  row("by blocks", advice.by_blocks,
      fmt::format("up to {} hand-overs of {} in a row, with one to begin and one to end", advice.hand_overs,
                  time_text(advice.hand_over)));
  row("in graph order", advice.in_order, "no bound, but an estimate: by blocks, each in the order of the graph");
}

void print_verdict(std::ostream &out, Advice const &advice) {
  if (advice.pays() && !advice.pays_in_order())
    fmt::print(
        out,
        "Threads do not pay for one evaluation in the order of the graph; in the best of orders {} may be {:.2f} "
        "times as fast as one.\n",
        advice.threads, advice.one_core / advice.best());
  else if (advice.pays())
    fmt::print(out,
               "Threads may pay for one evaluation: at best {} are {:.2f} times as fast as one, in the order of the "
               "graph {:.2f} times. A program must show it.\n",
               advice.threads, advice.one_core / advice.best(), advice.one_core / advice.in_order);
  else
    fmt::print(out, "Threads do not pay for one evaluation: at best {} take {:.3g} times as long as one.\n",
               advice.threads, advice.best() / advice.one_core);
  fmt::print(out, "A level is worth its barrier from {:.0f} of these operations on; it has {:.1f} on average.\n",
             advice.width_to_pay, advice.level_width);
  fmt::print(out, "So many hand-overs are at best worth it from {} on one core on; these operations take {}.\n",
             time_text(advice.time_to_pay), time_text(advice.one_core));
  fmt::print(out,
             "A batch gives more: {} samples at once are up to {:.3g} per second in place of {:.3g}, from {} samples a "
             "call on.\n",
             advice.threads, advice.batch_rate, advice.batch_rate / advice.threads, advice.batch_to_pay);
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

void print_advice(std::ostream &out, BlocksReport const &report) {
  Costs const &costs = *report.costs;
  std::uint32_t const count = report.kernel->blocks.count;
  if (costs.scale == 1 || count < 2) return; // not measured on a machine, or only one block
  if (!costs.threads) {
    fmt::print(out, "Whether threads pay '{}' does not say; symreal measure-costs measures it.\n", costs.name);
    return;
  }
  ThreadCosts const &threads = *costs.threads;
  if (!threads.is_measured()) {
    fmt::print(out, "Threads do not pay: the machine has one processor, on which they take turns.\n");
    return;
  }
  internal_check(report.advice.has_value()); // measured threads imply advice
  print_times(out, *report.advice);
  if (count > threads.processors)
    fmt::print(out, "The machine has {} processors: {} threads take turns on it. This is of one that has enough.\n",
               threads.processors, count);
  else if (count > threads.cores)
    fmt::print(out, "The machine has {} cores: some of {} threads share one, and are slower than is said here.\n",
               threads.cores, count);
  print_verdict(out, *report.advice);
}

std::string blocks_csv(Graph const &graph, KernelBlocks const &kernel) {
  std::vector<NodeId> const numbers = line_numbers(graph);
  std::string text = "node,block\n";
  for (TaskId task = 0; task < kernel.operations.node.size(); ++task)
    text += fmt::format("%{},{}\n", numbers[kernel.operations.node[task]], kernel.blocks[task]);
  return text;
}

} // namespace symreal::tool
