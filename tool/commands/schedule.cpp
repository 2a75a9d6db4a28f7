#include "engine/analysis/gantt/gantt.h"
#include "engine/analysis/tasks/stg.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"
#include "tool/scheduling/timetable_output.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace symreal::tool {
namespace {

struct Options {
  std::string file, units, cost, gantt;
  std::vector<std::string> outputs;
  std::int64_t communication = 0;
  Effort effort;
  bool json = false;
};

void require_sense(Options const &options) {
  if (options.communication < 0 || options.communication > 1'000'000'000)
    fail(DiagnosticId::bad_option, {}, "--communication takes a number from 0 to 1000000000");
  if (options.effort.level > most_effort)
    fail(DiagnosticId::bad_option, {}, "--effort takes a number from 0 to " + std::to_string(most_effort));
  for (std::string const &path : options.outputs) {
    auto const ending = std::filesystem::path(path).extension();
    if (ending != ".csv" && ending != ".json" && ending != ".stg")
      fail(DiagnosticId::bad_option, {}, "-o takes a file that ends in .csv, .json or .stg, not '" + path + "'");
  }
}

std::string output_text(std::string const &path, ScheduleReport const &report) {
  std::ostringstream text;
  auto const ending = std::filesystem::path(path).extension();
  if (ending == ".csv")
    write_csv(text, report);
  else if (ending == ".json")
    text << timetable_json(report).dump(1) << "\n";
  else
    write_stg(text, report.input->tasks, report.input->id);
  return text.str();
}

std::string gantt_text(ScheduleReport const &report) {
  Solution const &solution = *report.solution;
  std::ostringstream text;
  std::string const bound = solution.is_optimal() ? "optimal" : "at least " + std::to_string(solution.at_least);
  write_gantt(text, report.input->tasks, solution.timetable,
              {std::filesystem::path(report.input->file).filename().string() + ": length " +
                   std::to_string(solution.length) + ", " + bound,
               report.input->name, report.units->name});
  return text.str();
}

void run(Options const &options) {
  require_sense(options);
  TaskInput input = read_tasks(options.file, options.cost);
  NamedUnits const units = read_units(options.units, options.communication, input);
  std::vector<OutputFile> files;
  for (std::string const &path : options.outputs) files.push_back({path, {}});
  if (!options.gantt.empty()) files.push_back({options.gantt, {}});
  std::vector<std::string> paths = options.outputs;
  paths.push_back(options.gantt);
  require_writable(paths);
  Solution const solution = schedule_tasks(input.tasks, units.units, options.effort);
  ScheduleReport const report{&input, &units, &solution};
  for (OutputFile &file : files)
    file.text = !options.gantt.empty() && &file == &files.back() ? gantt_text(report) : output_text(file.path, report);
  write_outputs({std::move(files)});
  if (options.json)
    std::cout << summary_json(report).dump(2) << "\n";
  else
    print_summary(std::cout, report);
}

} // namespace

void add_schedule(CLI::App &app, Session &session) {
  CLI::App *command =
      app.add_subcommand("schedule", "Put the tasks of a graph on units, so that all is done as early as possible");
  auto options = std::make_shared<Options>();
  command
      ->add_option("file", options->file,
                   "Graph text, whose operations are the tasks; or a task graph in the format of the Standard Task "
                   "Graph set")
      ->required();
  command
      ->add_option("--units", options->units,
                   "How many units there are; or how many of each kind of operation: mul=2,arithmetic=1,other=1")
      ->required()
      ->type_name("N|KIND=N,...");
  command
      ->add_option("--communication", options->communication,
                   "Time after the end of a task before its successor can begin on another unit")
      ->type_name("TIME");
  command->add_option("--cost", options->cost, "How long an operation takes: unit (default), or table")
      ->type_name("unit|table");
  command
      ->add_option("--effort", options->effort.level,
                   "How much is tried, from 0 (lists only) to 3; in steps, so that the result is the same everywhere")
      ->capture_default_str();
  command->add_option("--seed", options->effort.seed, "Of the local search")->capture_default_str();
  command
      ->add_option("-o", options->outputs,
                   "Where the timetable goes, as .csv or .json, or the task graph, as .stg; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command->add_option("--gantt", options->gantt, "Draw the timetable as SVG")->type_name("FILE");
  command->add_flag("--json", options->json, "Print the summary as JSON");
  command->callback([options, &session] {
    refuse_flags(session);
    run(*options);
  });
}

} // namespace symreal::tool
