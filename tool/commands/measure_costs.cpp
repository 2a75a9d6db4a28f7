#include "engine/analysis/costs/measuring.h"

#include "engine/support/files.h"
#include "program/build/process.h"
#include "program/build/read_files.h"
#include "program/build/workspace.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

#include <iostream>
#include <memory>

namespace symreal::tool {
namespace {

struct Options {
  std::string output, compiler = "cc";
  unsigned rounds = 31;
};

std::string first_line(std::string const &text) { return text.substr(0, text.find('\n')); }

// The compiler's version, recorded since other compilers measure other costs.
std::string version_of(std::string const &compiler) {
  program::Captured const run = program::capture({{compiler, "--version"}});
  if (!run.outcome.success()) fail(DiagnosticId::compiler_missing, {}, "the compiler '" + compiler + "' cannot be run");
  return first_line(run.output);
}

struct Built {
  program::Workspace workspace{/*keep=*/false};
  std::string executable = workspace.file("costs");
  program::Captured run;
};

bool build(Options const &options, std::string_view program, std::string_view flags, Built &built) {
  std::string const source = built.workspace.file("costs.c");
  write_if_changed(source, std::string(program));
  std::vector<std::string> command = {options.compiler};
  for (std::string const &flag : program::split_words(flags)) command.push_back(flag);
  command.insert(command.end(), {"-o", built.executable, source, "-lm"});
  built.run = program::capture({command});
  return built.run.outcome.success();
}

std::string output_of(Options const &options, Built const &built) {
  program::Captured const measured = program::capture({{built.executable, std::to_string(options.rounds)}});
  return measured.outcome.success() ? measured.output : "";
}

// Compiles and runs a program; returns its output, empty if it crashes.
std::string output_of(Options const &options, std::string_view program, std::string_view flags) {
  Built built;
  if (!build(options, program, flags, built))
    fail(DiagnosticId::build_failed, {},
         "'" + options.compiler + "' fails on what measures: " + first_line(built.run.output));
  return output_of(options, built);
}

// Measures the cost of an OpenMP sections region, if the compiler has OpenMP.
void measure_sections(Options const &options, ThreadCosts &threads) {
  Built built;
  if (build(options, sections_measuring_program(), sections_measuring_flags, built))
    threads.sections = measured_sections(output_of(options, built));
}

void run(Options const &options) {
  if (options.compiler.find('/') != options.compiler.npos) program::note_read(options.compiler);
  require_writable(options.output);
  std::string const version = version_of(options.compiler);
  auto threads = measured_thread_costs(output_of(options, thread_measuring_program(), thread_measuring_flags));
  if (threads && threads->is_measured()) measure_sections(options, *threads);
  std::string const text = cost_file_text(output_of(options, measuring_program(), measuring_flags), version, threads);
  if (!threads || text.empty())
    fail(DiagnosticId::program_crashed, {}, "the program that measures did not come to its end");
  write_outputs({{{options.output, text}}});
  if (!threads->is_measured())
    std::cerr << "one processor: threads only take turns on it, so that barriers and hand-overs are not measured\n";
  else if (threads->cores == 1)
    std::cerr << "all processors are threads of one core: together they compute little more than one alone\n";
}

} // namespace

void add_measure_costs(CLI::App &app, Session &session) {
  CLI::App *command =
      app.add_subcommand("measure-costs", "Measure what operations and threads cost on this machine, for --cost");
  auto options = std::make_shared<Options>();
  command->add_option("-o", options->output, "Output file (JSON)")->required()->type_name("FILE");
  command->add_option("--cc", options->compiler, "The C compiler")->capture_default_str();
  command->add_option("--rounds", options->rounds, "Timings per operation; the median counts")
      ->check(CLI::Range(1U, 10000U))
      ->capture_default_str();
  command->callback([options, &session] {
    refuse_flags(session);
    run(*options);
  });
}

} // namespace symreal::tool
