#include "engine/analysis/figures/figures.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

namespace {

SlackFigures slack_figures(TaskGraph const &tasks, Levels const &levels) {
  SlackFigures result;
  std::vector<Time> slack;
  for (TaskId task = 0; task < tasks.size(); ++task)
    if (tasks.duration[task] != 0) slack.push_back(levels.slack(task));
  result.none = static_cast<std::size_t>(std::ranges::count(slack, 0));
  result.largest = *std::ranges::max_element(slack);
  auto const middle = slack.begin() + static_cast<std::ptrdiff_t>((slack.size() - 1) / 2);
  std::nth_element(slack.begin(), middle, slack.end());
  result.median = *middle;
  return result;
}

double throughput_work(Graph const &graph, Costs const &costs, std::vector<NodeId> const &nodes) {
  std::array<std::size_t, std::tuple_size_v<OperationCosts>> counts{};
  for (NodeId node : nodes) ++counts[static_cast<std::size_t>(graph.nodes[node].op)];
  double work = 0;
  for (std::size_t row = 0; row < counts.size(); ++row)
    work += static_cast<double>(counts[row]) * costs.throughput[row];
  return work;
}

std::vector<LengthBound> length_bounds(LevelBounds const &bounds, Time span) {
  constexpr std::uint32_t most = 1U << 20;
  std::vector<LengthBound> result;
  for (std::uint32_t units = 1; units <= most; units *= 2) {
    result.push_back({units, bounds.simple_length(units), bounds.length(units)});
    if (result.back().by_levels <= span) break;
  }
  return result;
}

void require_sense(Goal const &goal, Levels const &levels, Costs const &costs) {
  if (goal.units != 0 || goal.length == 0 || goal.length >= levels.span) return;
  fail(DiagnosticId::bad_option, {},
       fmt::format("no schedule has the length {}: the critical path takes {} {}", costs.in_unit(goal.length),
                   costs.in_unit(levels.span), costs.time_unit));
}

// An upper bound on the length of a list schedule.
Time longest_schedule(Goal const &goal, Levels const &levels) {
  return goal.units != 0 ? levels.span + levels.work / goal.units
                         : std::max(levels.span, std::min(goal.length, levels.work));
}

// A profile has a count per unit of time.
void require_countable(Time length, Costs const &costs) {
  constexpr Time most = Time{1} << 28;
  if (length > most)
    fail(DiagnosticId::cost_file, {costs.name},
         fmt::format("with these costs a schedule takes {} {}, and only {} can be counted", costs.in_unit(length),
                     costs.time_unit, costs.in_unit(most)));
}

} // namespace

Figures figures(Graph const &graph, Costs const &costs, Goal const &goal) {
  require_costs(costs, graph);
  Figures result;
  result.operations = operation_tasks(graph, costs.latency);
  TaskGraph const &tasks = result.operations.tasks;
  result.count = tasks.size() - static_cast<std::size_t>(std::ranges::count(tasks.duration, 0));
  if (result.count == 0)
    fail(DiagnosticId::nothing_to_analyze, {},
         fmt::format("kernel '{}' has no operation that costs something", graph.kernel));
  result.levels = levels(tasks);
  Levels const &all = result.levels;
  require_sense(goal, all, costs);
  require_countable(longest_schedule(goal, all), costs);
  result.slack = slack_figures(tasks, all);
  result.throughput_work = throughput_work(graph, costs, result.operations.node);
  for (TaskId task : critical_path(tasks, all))
    if (tasks.duration[task] != 0)
      result.critical_path.push_back({result.operations.node[task], all.earliest[task], tasks.duration[task]});
  result.from_inputs = profile(tasks, all.earliest, all.span);
  result.from_outputs = profile(tasks, all.latest, all.span);
  LevelBounds const bounds(tasks, all, result.from_inputs, result.from_outputs);
  result.bounds = length_bounds(bounds, all.span);
  result.levelled = goal.units != 0 ? level_for_units(tasks, all, goal.units)
                                    : level_for_length(tasks, all, bounds, std::max(goal.length, all.span));
  result.least_units = bounds.units(result.levelled.length);
  result.evened = profile(tasks, result.levelled.start, result.levelled.length);
  return result;
}

} // namespace symreal
