#include "tool/html/data.h"
#include "tool/html/packed.h"

#include <algorithm>

namespace symreal::tool {

Json timetable_data(Graph const &graph, ScheduleReport const &report, std::vector<NodeId> const &node_of_task) {
  Timetable const &table = report.solution->timetable;
  TaskGraph const &tasks = report.input->tasks;
  std::vector<NodeId> const shown = shown_numbers(graph);
  std::vector<std::vector<TaskId>> by_unit(report.units->name.size());
  for (TaskId task = 0; task < tasks.size(); ++task)
    if (tasks.duration[task] != 0) by_unit[table.unit[task]].push_back(task);
  Json json = summary_json(report);
  for (std::size_t unit = 0; unit < by_unit.size(); ++unit) {
    std::ranges::stable_sort(by_unit[unit], {}, [&](TaskId task) { return table.start[task]; });
    PackedNumbers wait, duration, node;
    Time end = 0;
    for (TaskId task : by_unit[unit]) {
      wait.add(static_cast<std::uint64_t>(table.start[task] - end));
      duration.add(static_cast<std::uint64_t>(tasks.duration[task]));
      node.add(shown[node_of_task[task]]);
      end = table.start[task] + tasks.duration[task];
    }
    json["units"][unit].update(
        {{"tasks", by_unit[unit].size()}, {"wait", wait.text()}, {"duration", duration.text()}, {"node", node.text()}});
  }
  return json;
}

} // namespace symreal::tool
