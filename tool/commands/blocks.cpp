#include "tool/analysis/blocks_report.h"
#include "tool/commands/analyzed_graph.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, cost = "unit", csv;
  std::uint32_t blocks = 0;
  PassOptions passes;
  bool json = false;
};

void run(Options const &options, CLI::App const &command) {
  Costs const costs = costs_named(options.cost);
  Graph const graph = analyzed_graph(command, options.passes, options.file);
  KernelBlocks const kernel = cut_kernel(graph, costs, options.blocks);
  BlocksReport const report = blocks_report(graph, costs, kernel);
  if (!options.csv.empty()) write_outputs({{{options.csv, blocks_csv(graph, kernel)}}});
  if (options.json) {
    std::cout << to_json(report).dump(2) << "\n";
    return;
  }
  print_blocks(std::cout, report);
  print_advice(std::cout, report);
}

} // namespace

void add_blocks(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand(
      "blocks", "Partition the operations of a graph into blocks with a small cut; report whether threads pay");
  auto options = std::make_shared<Options>();
  command->add_option("graph", options->file, "Graph text, as written by generate --graph")->required();
  command->add_option("--blocks", options->blocks, "Block count")
      ->required()
      ->check(CLI::Range(1U, 1U << 20))
      ->type_name("K");
  add_cost_option(*command, options->cost);
  add_passes_before_analysis(*command, options->passes);
  command->add_flag("--json", options->json, "Print the figures as JSON");
  command->add_option("--csv", options->csv, "Also write the block of every operation")->type_name("FILE");
  command->callback([options, command, &session] {
    refuse_flags(session);
    run(*options, *command);
  });
}

} // namespace symreal::tool
