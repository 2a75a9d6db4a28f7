#include "program/verification.h"
#include "tool/console.h"
#include "tool/subcommands.h"
#include "tool/verify_numeric.h"
#include "tool/verify_report.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

namespace symreal::tool {
namespace {

struct Options {
  SourceOptions source;
  std::vector<std::string> files; // sources, then the generated file
  program::VerificationOptions verification;
  CLI::Option *tolerance = nullptr;
  NumericOptions numeric;
  bool json = false;
};

int run_numeric(CLI::App &command, Options &options, Session &session) {
  ProjectOptions &project = options.source.project;
  project.request.sources = options.files;
  project.configure(command, session.configured);
  bool const is_given = command.get_option("--cxx")->count() != 0;
  return verify_numeric(command, options.numeric, project, is_given ? options.source.front.build.compiler : "",
                        session);
}

int run(CLI::App &command, Options &options, Session &session) {
  SourceOptions &source = options.source;
  if (!options.files.empty()) source.project.request.sources.assign(options.files.begin(), options.files.end() - 1);
  source.project.configure(command, session.configured);
  if (options.files.size() < (source.project.build.empty() ? 2 : 1))
    fail(DiagnosticId::bad_option, {}, "verify takes sources and the generated C file");
  std::string const &generated = options.files.back();

  program::Banner banner = program::read_banner(generated);
  if (options.tolerance->count() != 0 && banner.mode != FloatingPoint::fast)
    fail(DiagnosticId::option_without_effect, {},
         "--tol is for code of mode fast; this is of mode " + std::string(to_string(banner.mode)));
  Console console;
  program::FrontRequest request = source.request(session.flags);
  if (!options.numeric.c_compiler.empty()) request.build.c_compiler = options.numeric.c_compiler;
  request.replay = true;
  request.run.decisions = banner.decisions;
  request.run.floating_point = to_string(banner.mode);
  auto front = program::run_front(request, console.talk());
  if (!front) return error;
  if (request.keep) console.note("the build directory is " + front->workspace->path());

  console.stage("verifying");
  program::Recorded const &recorded = program::require_match(front->kernels, banner, generated);
  program::Verification verification =
      program::verify(*front, request.run, recorded, generated, banner, options.verification);
  console.clear();
  print_verification(std::cerr, recorded.graph, verification);
  if (options.json) std::cout << to_json(recorded.graph, verification).dump(2) << "\n";
  if (auto failure = verification_failure(recorded.graph, verification, options.verification, generated)) {
    console.report(*failure);
    return verification_failed;
  }
  return clean;
}

} // namespace

void add_verify(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("verify", "Compare the generated code with the original on many inputs");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "The sources of the program, then the generated C file");
  options->numeric.add_to(*command);
  options->source.add_to(*command, false);
  program::VerificationOptions &verification = options->verification;
  command->add_option("--samples", verification.samples, "How many inputs to try")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--min-samples", verification.min_samples, "How many of them must satisfy the premises of the mode")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", verification.seed, "Begins the sequence of inputs")->capture_default_str();
  options->tolerance = command->add_option("--tol", verification.tolerance, "Largest relative error in mode fast")
                           ->capture_default_str();
  command->add_flag("--json", options->json, "Print the result as JSON to standard output");
  command->callback([options, command, &session] {
    session.status =
        options->numeric.enabled ? run_numeric(*command, *options, session) : run(*command, *options, session);
  });
}

} // namespace symreal::tool
