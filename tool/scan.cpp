#include "tool/project_options.h"
#include "tool/reached.h"
#include "tool/readiness.h"
#include "tool/subcommands.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

struct Options {
  ProjectOptions project;
  bool list = false, json = false, sarif = false;
  std::string kernel;
};

void run(CLI::App &command, Options &options, Session &session) {
  options.project.configure(command, session.configured);
  if (options.list + options.json + options.sarif + !options.kernel.empty() > 1)
    fail(DiagnosticId::bad_option, {}, "only one of --list, --json, --sarif and --kernel says what is printed");
  rewrite::Request request = only_rewritten(options.project.complete(session.flags));
  request.leave_out_broken = true;
  rewrite::Result const result = rewrite::run(request);
  if (!options.kernel.empty())
    print_reach(std::cout, options.kernel, rewrite::reach_of(options.kernel, request), result);
  else if (options.json)
    std::cout << readiness_json(request, result).dump(2) << "\n";
  else if (options.sarif)
    std::cout << sarif(result).dump(2) << "\n";
  else
    print_readiness(std::cout, request, result, options.list);
  if (!result.left_out.empty()) session.status = partly_skipped;
}

} // namespace

void add_scan(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("scan", "Tell what would be converted and what is in the way; writes nothing");
  auto options = std::make_shared<Options>();
  options->project.add_to(*command);
  command
      ->add_option("--kernel", options->kernel,
                   "Tell of this function what it reaches: state that outlives a call, decisions, what is in the way")
      ->type_name("FUNCTION");
  command->add_flag("--list", options->list, "Also list every place");
  command->add_flag("--json", options->json, "Print the report as JSON, every place included");
  command->add_flag("--sarif", options->sarif, "Print what is in the way as SARIF 2.1.0");
  command->callback([options, command, &session] { run(*command, *options, session); });
}

} // namespace symreal::tool
