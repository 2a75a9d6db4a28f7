#include "program/verification.h"
#include "program/wrapped_original.h"
#include "support/files.h"
#include "tool/calls/driver_program.h"
#include "tool/commands/subcommands.h"
#include "tool/commands/verify_numeric.h"
#include "tool/report/console.h"
#include "tool/report/verify_report.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace symreal::tool {
namespace {

namespace fs = std::filesystem;

struct Options {
  SourceOptions source;
  std::vector<std::string> files; // sources, then generated files
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
                        options.source.front.keep, session);
}

// The generated files end the list. The last one is taken for one in any case: what is wrong with it will be told.
std::vector<std::string> take_generated(std::vector<std::string> &files) {
  auto first = files.end();
  while (first != files.begin() && program::is_generated(*(first - 1))) --first;
  if (first == files.end() && first != files.begin()) --first;
  std::vector<std::string> generated(first, files.end());
  files.erase(first, files.end());
  return generated;
}

// The programs, recorded as a generated file was.
std::optional<program::Front> make_front(Options const &options, Session &session, program::Banner const &banner,
                                         program::RunOptions &run, Console &console) {
  program::FrontRequest request = options.source.request(session.flags);
  if (!options.numeric.c_compiler.empty()) request.build.c_compiler = options.numeric.c_compiler;
  request.replay = true;
  request.run.decisions = banner.decisions;
  request.run.floating_point = to_string(banner.mode);
  run = request.run;
  std::optional<program::Front> front;
  with_driver(request, options.source.project.calls, console.talk(), console,
              [&](program::FrontRequest const &called, program::Talk const &talk) { front = run_front(called, talk); });
  if (front && request.keep) console.note("the build directory is " + front->workspace->path());
  return front;
}

// Does the wrapper lie beside the generated file?
bool has_wrapper(std::string const &generated, program::Recorded const &recorded) {
  fs::path const stem = fs::path(generated).replace_extension();
  for (char const *suffix : {"_wrapper.c", "_wrapper.cpp"}) {
    std::string const path = stem.string() + suffix;
    if (!recorded.kernel.is_function || program::is_generated_cpp(generated) || !fs::exists(path)) continue;
    if (!program::is_wrapper_of(read_file(path), recorded))
      fail(DiagnosticId::foreign_file, {path, 1, 1},
           "this wrapper was generated for another form of kernel '" + recorded.kernel.name + "'");
    return true;
  }
  return false;
}

int run(CLI::App &command, Options &options, Session &session) {
  std::vector<std::string> sources = options.files;
  std::vector<std::string> const generated = take_generated(sources);
  if (!sources.empty()) options.source.project.request.sources = sources;
  options.source.project.configure(command, session.configured);
  if (generated.empty() || (sources.empty() && options.source.project.build.empty()))
    fail(DiagnosticId::bad_option, {}, "verify takes sources and generated files in C or C++");
  std::vector<program::Banner> banners;
  for (std::string const &path : generated) {
    banners.push_back(program::read_banner(path));
    if (options.tolerance->count() != 0 && banners.back().mode != FloatingPoint::fast && !banners.back().is_single)
      fail(DiagnosticId::option_without_effect, {},
           "--tol is for code of mode fast and for single precision; this is of mode " +
               std::string(to_string(banners.back().mode)));
  }

  Console console;
  std::optional<program::Front> front;
  program::RunOptions as;
  int status = clean;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < generated.size(); ++k) {
    program::Banner const &banner = banners[k];
    if (!front || banner.decisions != as.decisions || to_string(banner.mode) != as.floating_point) {
      front.reset();
      front = make_front(options, session, banner, as, console);
      if (!front) return error;
    }
    console.stage("verifying");
    program::Recorded const &recorded = program::require_match(front->kernels, banner, generated[k]);
    program::VerificationOptions asked = options.verification;
    asked.wrapper = !banner.is_single && has_wrapper(generated[k], recorded);
    if (banner.is_single && options.tolerance->count() == 0) asked.tolerance = program::single_tolerance;
    program::Verification const verification = program::verify(*front, as, recorded, generated[k], banner, asked);
    console.clear();
    print_verification(std::cerr, recorded.graph, verification);
    if (options.json) json.push_back(to_json(recorded.graph, verification));
    if (auto failure = verification_failure(recorded.graph, verification, options.verification, generated[k])) {
      console.report(*failure);
      status = verification_failed;
    }
  }
  if (options.json)
    std::cout << (json.size() == 1 ? json.front() : nlohmann::ordered_json{{"kernels", json}}).dump(2) << "\n";
  return status;
}

} // namespace

void add_verify(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("verify", "Compare the generated code with the original on many inputs");
  auto options = std::make_shared<Options>();
  command->add_option("files", options->files, "The sources of the program, then generated files in C or C++");
  options->numeric.add_to(*command);
  options->source.add_to(*command);
  program::VerificationOptions &verification = options->verification;
  command->add_option("--samples", verification.samples, "How many inputs to try")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      ->add_option("--min-samples", verification.min_samples, "How many of them must satisfy the premises of the mode")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seed", verification.seed, "Where the sequence of inputs starts")->capture_default_str();
  options->tolerance = command
                           ->add_option("--tol", verification.tolerance,
                                        "Largest relative error in mode fast; in single precision 0.001 unless given")
                           ->capture_default_str();
  command->add_flag("--json", options->json, "Print the result as JSON to standard output");
  command->callback([options, command, &session] {
    session.status =
        options->numeric.enabled ? run_numeric(*command, *options, session) : run(*command, *options, session);
  });
}

} // namespace symreal::tool
