#include "program/record/path_runs.h"

#include "engine/graph/graph_binary.h"
#include "engine/support/files.h"

#include <algorithm>
#include <filesystem>

namespace symreal::program {

Command recording_command(std::string const &executable, RunOptions const &options, std::string const &directory) {
  Command command{.arguments = {executable},
                  .directory = options.directory,
                  .standard_input = options.standard_input,
                  .time_limit = options.time_limit};
  command.arguments.insert(command.arguments.end(), options.arguments.begin(), options.arguments.end());
  std::optional<ExploreBounds> const bounds = explore_bounds(options.decisions);
  command.notes_opened = true;
  command.at_fixed_addresses = bounds.has_value();
  std::string const policy = !bounds ? options.decisions : bounds->selects ? "auto" : "explore";
  command.environment = {"SYMREAL_RECORD=" + directory, "SYMREAL_DECISIONS=" + policy,
                         "SYMREAL_FP=" + options.floating_point,
                         options.places ? "SYMREAL_PLACES=1" : "SYMREAL_PLACES=0"};
  if (options.from_instructions) command.environment.emplace_back("SYMREAL_WATCH=1");
  return command;
}

bool is_to_explore(Events const &first_run, std::size_t kernel) {
  return kernel == 0
             ? !first_run.decided.empty()
             : std::find(first_run.undecided.begin(), first_run.undecided.end(), kernel) != first_run.undecided.end();
}

double path_time_limit(double first_run, RunOptions const &options) {
  double const generous = 20 * first_run + 5;
  return options.time_limit > 0 ? std::min(options.time_limit, generous) : generous;
}

PathRun run_along(std::string const &path_variable, std::size_t kernel, std::string const &executable,
                  RunOptions const &options, std::string const &directory) {
  std::string const graph = directory + "/" + std::to_string(kernel) + ".graph", taken = directory + "/taken";
  for (std::string const &old : {graph, taken, directory + "/events"}) std::filesystem::remove(old);
  Command program = recording_command(executable, options, directory);
  program.environment.push_back(path_variable);
  program.environment.push_back("SYMREAL_KERNELS=" + std::to_string(kernel + 1));
  Outcome const end = run(program, [](std::string_view) {}); // discards the output, which belongs to another path
  PathRun result{read_events(directory + "/events")};
  result.is_late = end.ending == Ending::timed_out;
  result.seconds = end.seconds;
  if (std::filesystem::exists(graph)) result.graph = read_binary_graph(graph);
  if (std::filesystem::exists(taken)) result.taken = read_file(taken);
  return result;
}

} // namespace symreal::program
