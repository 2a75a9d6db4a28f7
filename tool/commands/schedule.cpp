#include "engine/analysis/scheduling/gantt.h"
#include "engine/analysis/tasks/stg.h"
#include "tool/analysis/timetable.h"
#include "tool/commands/subcommands.h"
#include "tool/output/outputs.h"

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
  CLI::App *command = app.add_subcommand("schedule", "Plan the tasks of a graph on units, minimising the makespan");
  auto options = std::make_shared<Options>();
  command
      ->add_option("file", options->file,
                   "Graph text (its operations are the tasks), or a task graph in the Standard Task Graph format")
      ->required();
  command
      ->add_option("--units", options->units,
                   "Number of units, or number per kind of operation: mul=2,arithmetic=1,other=1")
      ->required()
      ->type_name("N|KIND=N,...");
  command
      ->add_option("--communication", options->communication, "Delay between a task and its successor on another unit")
      ->type_name("TIME");
  command->add_option("--cost", options->cost, "Duration of an operation: unit (default) or table")
      ->type_name("unit|table");
  command
      ->add_option("--effort", options->effort.level,
                   "Search effort, 0 (list scheduling) to 3; bounds steps, not time, so results are reproducible")
      ->capture_default_str();
  command->add_option("--seed", options->effort.seed, "Local search seed")->capture_default_str();
  command
      ->add_option("-o", options->outputs,
                   "Output file for the timetable (.csv, .json) or the task graph (.stg); repeatable")
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
