#include "program/record/oracle.h"

#include "engine/graph/names.h"
#include "engine/support/number.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/subcommands.h"
#include "tool/options/option_table.h"
#include "tool/report/console.h"

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace symreal::tool {
namespace {

struct Options {
  SourceOptions source;
  program::OracleOptions oracle;
  std::string decisions = "guard", mode = "finite";
  bool json = false;
};

void print(Graph const &graph, program::OracleComparison const &comparison) {
  std::cerr << fmt::format("kernel {}: {} operations recorded, {} by the oracle\n", graph.kernel, comparison.operations,
                           comparison.oracle_operations);
  std::cerr << fmt::format("  {} samples within the premises and the guards of both, {} outside\n", comparison.samples,
                           comparison.outside);
  constexpr std::size_t most = 16;
  std::size_t told = 0;
  if (!comparison.only_oracle.empty())
    std::cerr << fmt::format("  operations of the oracle whose values the recorded graph does not have, at {} lines:\n",
                             comparison.only_oracle.size());
  for (auto const &[line, count] : comparison.only_oracle) {
    if (++told > most) continue;
    std::cerr << fmt::format("    {}: {}\n", line, count);
  }
  if (told > most) std::cerr << fmt::format("    and {} more\n", told - most);
}

nlohmann::ordered_json to_json(Graph const &graph, program::OracleComparison const &comparison) {
  nlohmann::ordered_json lines = nlohmann::ordered_json::object();
  for (auto const &[line, count] : comparison.only_oracle) lines[line] = count;
  return {{"kernel", graph.kernel},
          {"operations", comparison.operations},
          {"oracle_operations", comparison.oracle_operations},
          {"samples", comparison.samples},
          {"outside", comparison.outside},
          {"different", std::ranges::count_if(comparison.outputs, [](auto const &one) { return one.different != 0; })},
          {"only_oracle", lines}};
}

std::optional<Diagnostic> failure_of(Graph const &graph, program::OracleComparison const &comparison,
                                     program::OracleOptions const &options) {
  Place const &place = graph.outputs.front().place;
  std::vector<std::string> const names = identifiers(graph.outputs);
  for (std::size_t i = 0; i < graph.outputs.size(); ++i)
    for (std::uint32_t element = 0; element < graph.outputs[i].count; ++element) {
      OutputComparison const &output = comparison.outputs[graph.outputs[i].first + element];
      if (output.different == 0) continue;
      return Diagnostic{DiagnosticId::oracle_mismatch, place,
                        fmt::format("kernel '{}': the oracle gives {} = {}, the recorded graph {}, {} ULP apart, on {} "
                                    "of {} samples",
                                    graph.kernel, element_name(names[i], graph.outputs[i], element),
                                    shortest(output.original), shortest(output.generated), output.worst_ulp,
                                    output.different, comparison.samples)};
    }
  std::size_t const wanted = std::min(options.samples, options.min_samples);
  if (comparison.samples < wanted)
    return Diagnostic{DiagnosticId::too_few_samples, place,
                      fmt::format("only {} samples lie within the premises and the guards of both recordings of kernel "
                                  "'{}', and {} are required",
                                  comparison.samples, graph.kernel, wanted)};
  return {};
}

struct Recordings {
  std::vector<Graph> graphs, by_oracle; // of the kernels, in the same order
};

std::vector<Graph> graphs_of(std::vector<program::Recorded> kernels) {
  std::vector<Graph> graphs;
  for (program::Recorded &one : kernels) graphs.push_back(std::move(one.graph));
  return graphs;
}

// Records the kernels twice; nullopt after an error was reported.
std::optional<Recordings> record(program::FrontRequest const &request, Options const &options, Console &console) {
  std::optional<Recordings> recordings;
  with_driver(request, options.source.project.calls, console.talk(), console,
              [&](program::FrontRequest const &called, program::Talk const &talk) {
                std::optional<program::Front> front = run_front(called, talk);
                if (!front) return;
                if (called.keep) console.note("the build directory is " + front->workspace->path());
                talk.stage("recording instructions");
                program::Recording oracle = program::record_instructions(*front, called.run, talk.program_output);
                if (report_all(oracle.diagnostics, talk.report))
                  recordings = {graphs_of(std::move(front->kernels)), graphs_of(std::move(oracle.kernels))};
              });
  return recordings;
}

int run(CLI::App &command, Options &options, Session &session) {
  options.source.project.configure(command, session.configured);
  require_one_of("--decisions", options.decisions, "error|guard|select");
  require_one_of("--fp", options.mode, "finite|strict");
  options.oracle.mode = options.mode == "strict" ? FloatingPoint::strict : FloatingPoint::finite;
  Console console;
  program::FrontRequest request = options.source.request(session.flags);
  request.run.decisions = options.decisions;
  request.run.floating_point = options.mode;
  request.run.places = true;
  std::optional<Recordings> const recordings = record(request, options, console);
  if (!recordings) return error;
  console.stage("comparing");
  int status = clean;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < recordings->graphs.size(); ++k) {
    Graph const &graph = recordings->graphs[k];
    program::OracleComparison const comparison =
        program::compare_recordings(graph, recordings->by_oracle.at(k), options.oracle);
    console.clear();
    print(graph, comparison);
    json.push_back(to_json(graph, comparison));
    if (auto const failure = failure_of(graph, comparison, options.oracle)) {
      console.report(*failure);
      status = verification_failed;
    }
  }
  if (options.json) std::cout << nlohmann::ordered_json{{"kernels", json}}.dump(2) << "\n";
  return status;
}

} // namespace

void add_oracle(CLI::App &app, Session &session) {
  CLI::App *command =
      app.add_subcommand("oracle", "Record the instructions of the original as well, and compare both graphs");
  auto options = std::make_shared<Options>();
  command->add_option("sources", options->source.project.request.sources,
                      "C and C++ sources of the program; with -p by default all of them");
  options->source.add_to(*command);
  command->add_option("--decisions", options->decisions, "Decisions of the recorded graph: error, guard or select")
      ->capture_default_str();
  command->add_option("--fp", options->mode, "Floating-point mode: finite or strict")->capture_default_str();
  command->add_option("--samples", options->oracle.samples, "Number of samples")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--min-samples", options->oracle.min_samples,
                   "Minimum number of samples meeting the mode's premises and the guards of both")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", options->oracle.seed, "Seed of the sequence of samples")->capture_default_str();
  command->add_flag("--json", options->json, "Print the result as JSON to standard output");
  command->callback([options, command, &session] { session.status = run(*command, *options, session); });
}

} // namespace symreal::tool
