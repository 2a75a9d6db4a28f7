#include "program/record/record.h"
#include "engine/graph/graph_text.h"
#include "program/build/read_files.h"
#include "tool/commands/subcommands.h"
#include "tool/options/option_table.h"
#include "tool/options/recording_options.h"
#include "tool/output/outputs.h"
#include "tool/report/console.h"

#include <filesystem>
#include <memory>
#include <sstream>

namespace symreal::tool {
namespace {

struct Options {
  program::RunOptions run;
  std::string directory = ".";
  DecisionsOption decisions;
  FrozenOption frozen;
};

// Absolute path, since the program runs in another directory.
std::string program_path(std::string const &name) {
  return name.find('/') == name.npos ? name : std::filesystem::absolute(name).string();
}

int run(Options options, Session const &session) {
  options.decisions.require_sense();
  options.run.decisions = options.decisions.of_recording();
  options.run.paths_met = options.decisions.paths_met;
  require_one_of("--fp", options.run.floating_point, "finite|strict|fast");
  options.frozen.require_sense();
  if (session.flags.empty()) fail(DiagnosticId::bad_option, {}, "name the program and its arguments after --");
  options.run.arguments.assign(session.flags.begin() + 1, session.flags.end());
  options.run.places = true;
  if (!options.run.standard_input.empty()) program::note_read(options.run.standard_input);
  program::note_read(program_path(session.flags.front()));
  Console console;
  console.stage("recording");
  program::Workspace const workspace(/*keep=*/false);
  program::Overlay const overlay;
  program::Recording recording = program::record(program_path(session.flags.front()), options.run, {}, {}, overlay,
                                                 workspace, console.talk().program_output);
  program::Talk const talk = console.talk();
  bool const is_clean = report_all(recording.diagnostics, talk.report);
  if (!is_clean || !options.frozen.accepts(recording.kernels, talk.report)) return error;
  std::vector<OutputFile> files;
  for (program::Recorded const &recorded : recording.kernels) {
    std::ostringstream text;
    write_graph(text, recorded.graph);
    files.push_back(
        {(std::filesystem::path(options.directory) / (recorded.kernel.name + ".graph")).string(), text.str()});
  }
  for (std::string const &path : write_outputs({std::move(files), {}, {options.directory}}))
    console.note("wrote " + path);
  return clean;
}

} // namespace

void add_record(CLI::App &app, Session &session) {
  CLI::App *command = app.add_subcommand("record", "Run a program that symreal-c++ built; keep its graphs");
  auto options = std::make_shared<Options>();
  command->add_option("-o", options->directory, "Directory of the graphs, NAME.graph for each kernel")
      ->type_name("DIR")
      ->capture_default_str();
  command->add_option("--fp", options->run.floating_point, "Floating-point mode: finite, strict or fast")
      ->capture_default_str();
  options->decisions.add_to(*command);
  options->frozen.add_to(*command);
  command->add_option("--stdin", options->run.standard_input, "File that the program reads as standard input")
      ->type_name("FILE");
  command->add_option("--cwd", options->run.directory, "Working directory of the program")->type_name("DIR");
  command->add_option("--timeout", options->run.time_limit, "Time limit of the program, in seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->callback([options, &session] { session.status = run(*options, session); });
}

} // namespace symreal::tool
