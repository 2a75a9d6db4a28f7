#include "program/build/compile.h"
#include "tool/commands/subcommands.h"
#include "tool/options/source_options.h"
#include "tool/report/scan_report.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

struct Options {
  ProjectOptions project;
  bool list = false, json = false, sarif = false, compile = false;
  std::string kernel, compiler = "c++";
};

// Adds the compiler's errors in symbolic mode to the obstacles.
void compile(rewrite::Request const &request, Options const &options, rewrite::Result &result) {
  program::BuildRequest build;
  build.compiler = options.compiler;
  for (rewrite::Compilation const &one : rewrite::compilations_of(request))
    if (std::find(result.left_out.begin(), result.left_out.end(), one.source) == result.left_out.end())
      build.sources.push_back(one);
  for (Diagnostic &one : program::symbolic_check(build, result)) result.diagnostics.push_back(std::move(one));
}

void run(CLI::App &command, Options &options, Session &session) {
  options.project.configure(command, session.configured);
  if (options.list + options.json + options.sarif + !options.kernel.empty() > 1)
    fail(DiagnosticId::bad_option, {}, "choose only one of --list, --json, --sarif and --kernel");
  rewrite::Request request = only_rewritten(options.project.complete(session.flags));
  request.leave_out_broken = true;
  if (options.compile) request.defines = program::reference_defines();
  rewrite::Result result = rewrite::run(request);
  std::size_t const found = result.diagnostics.size();
  if (options.compile) compile(request, options, result);
  if (!options.kernel.empty())
    print_reach(std::cout, options.kernel, rewrite::reach_of(options.kernel, request), result);
  else if (options.json)
    std::cout << readiness_json(request, result).dump(2) << "\n";
  else if (options.sarif)
    std::cout << sarif(result).dump(2) << "\n";
  else
    print_readiness(std::cout, request, result, options.list);
  if (!result.left_out.empty() || result.diagnostics.size() > found) session.status = partly_skipped;
}

} // namespace

void add_scan(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("scan", "Report what would be converted and what blocks it; writes nothing");
  auto options = std::make_shared<Options>();
  options->project.add_to(*command);
  command
      ->add_option("--kernel", options->kernel,
                   "Report what this function reaches: state that outlives a call, decisions, what blocks it")
      ->type_name("FUNCTION");
  command->add_flag("--compile", options->compile,
                    "Also parse the symbolic form of each source with a compiler and report those it rejects");
  command->add_option("--cxx", options->compiler, "C++ compiler")->capture_default_str();
  command->add_flag("--list", options->list, "Also list every place");
  command->add_flag("--json", options->json, "Print the report as JSON, every place included");
  command->add_flag("--sarif", options->sarif, "Print what blocks the conversion as SARIF 2.1.0");
  command->callback([options, command, &session] { run(*command, *options, session); });
}

} // namespace symreal::tool
