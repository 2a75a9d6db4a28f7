#include "diagnostics/diagnostic.h"
#include "tool/project_options.h"
#include "tool/subcommands.h"

#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

struct Options {
  ProjectOptions project;
  bool diff = false;
  std::string out_root;
};

void run(Options const &options, Session &session) {
  if (options.diff == !options.out_root.empty())
    fail(DiagnosticId::bad_option, {}, "one of --diff and --out-root says where the rewritten text goes");
  rewrite::Result result = rewrite::run(options.project.complete(session.flags));
  for (Diagnostic const &diagnostic : result.diagnostics) {
    print(std::cerr, diagnostic);
    if (diagnostic.severity == Severity::error) session.status = error;
  }
  if (session.status != clean) return;
  if (!options.out_root.empty()) {
    rewrite::write_mirror(result.files, options.out_root);
    return;
  }
  for (rewrite::File const &file : result.files) std::cout << rewrite::unified_diff(file);
}

} // namespace

void add_rewrite(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("rewrite", "Show or write the sources in their symbolic form");
  auto options = std::make_shared<Options>();
  options->project.add_to(*command);
  command->add_flag("--diff", options->diff, "Print a unified diff");
  command->add_option("--out-root", options->out_root, "Write a mirror of the files below this directory")
      ->type_name("DIR");
  command->callback([options, &session] { run(*options, session); });
}

} // namespace symreal::tool
