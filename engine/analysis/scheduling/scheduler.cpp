#include "engine/analysis/scheduling/scheduler.h"

#include "engine/analysis/scheduling/communicating.h"
#include "engine/analysis/scheduling/exact.h"
#include "engine/analysis/scheduling/improvement.h"
#include "engine/analysis/scheduling/packing.h"

#include <algorithm>

namespace symreal {

namespace {

// Solution of a part, without units.
struct PartSolution {
  std::vector<Time> start;
  Time length, interval_bound, at_least;
  std::uint64_t nodes = 0; // nodes of its exact search
};

void take(PartSolution &result, TaskGraph const &graph, std::vector<Time> const &start) {
  if (start.empty()) return;
  result.start = start;
  result.length = length(graph, start);
}

// Raises the bound and shortens the timetable of a small part until they meet or the nodes are used up.
void finish_exactly(PartSolution &result, TaskGraph const &graph, Network const &network, Units const &units,
                    Windows const &window, std::uint64_t nodes) {
  if (nodes == 0) return;
  if (graph.predecessor.empty()) {
    IndependentPacking const packing = pack_independent(network, units, result.at_least, result.length);
    take(result, graph, packing.start);
    result.at_least = packing.at_least;
  } else {
    result.at_least = packing_bound(network, units, window, result.at_least, result.length);
  }
  if (result.at_least == result.length) return;
  ExactResult const exact = search_exactly(network, units, window, result.length, result.at_least, nodes);
  take(result, graph, exact.start);
  result.nodes = std::min(exact.nodes, nodes);
  if (exact.is_complete) result.at_least = result.length;
}

PartSolution schedule_part(TaskGraph const &graph, Units const &units, Effort const &effort,
                           std::uint64_t &nodes_left) {
  Network const network = make_network(graph);
  bool const is_large = graph.size() > most_searched_tasks;
  Windows const window = windows(network, units);
  Bounds const bound = bounds(network, units, window, is_large ? 1'000'000 : 5'000'000);
  Improvement improvement(network, units, bound.best());
  if (is_large)
    improvement.try_one_list();
  else
    improvement.try_lists(window);
  improvement.search(window, effort.search_steps(graph.size()), effort.seed);
  PartSolution result{improvement.start(), improvement.length(), bound.interval, bound.best(), 0};
  if (!improvement.is_enough())
    finish_exactly(result, graph, network, units, window, std::min(effort.exact_nodes(graph.size()), nodes_left));
  nodes_left -= result.nodes;
  return result;
}

Solution schedule_chain(TaskGraph const &graph, Units const &units, Effort const &effort) {
  Network const network = make_network(graph);
  Solution result;
  std::vector<Time> start(graph.size());
  result.bounds.critical_path = critical_path(network);
  result.bounds.work = work_bound(network, units);
  std::uint64_t nodes_left = effort.exact_nodes(1); // shared by all parts
  for (std::vector<TaskId> const &part : chain_of_parts(network)) {
    PartSolution const solved = schedule_part(part_graph(graph, part), units, effort, nodes_left);
    for (std::size_t i = 0; i < part.size(); ++i) start[part[i]] = result.length + solved.start[i];
    result.length += solved.length;
    result.at_least += solved.at_least;
    result.bounds.interval += solved.interval_bound;
  }
  result.timetable = assign_units(graph, units, start);
  return result;
}

std::size_t times_ten(std::size_t number, unsigned times) {
  for (; times != 0; --times) number *= 10;
  return number;
}

} // namespace

Solution schedule_tasks(TaskGraph const &graph, Units const &units, Effort const &effort) {
  if (graph.size() == 0) return {};
  return units.communication == 0 ? schedule_chain(graph, units, effort) : schedule_communicating(graph, units, effort);
}

std::size_t Effort::search_steps(std::size_t tasks, std::size_t cost) const {
  if (level == 0 || tasks == 0 || tasks > most_searched_tasks) return 0;
  return std::min(times_ten(200, level - 1), times_ten(400'000, level - 1) / (tasks * cost));
}

std::uint64_t Effort::exact_nodes(std::size_t tasks) const {
  if (level == 0 || tasks > most_exact_tasks) return 0;
  if (tasks <= 30) return level == most_effort ? ~std::uint64_t{0} : times_ten(5'000'000, level - 1);
  return times_ten(200'000, level - 1);
}

} // namespace symreal
