#include "engine/analysis/scheduling/communicating.h"

#include "engine/analysis/scheduling/exact.h"
#include "engine/analysis/scheduling/exact_communicating.h"
#include "engine/analysis/scheduling/random.h"
#include "engine/analysis/scheduling/unit_chooser.h"

#include <algorithm>

namespace symreal {
namespace {

constexpr Time scale = 16; // of priorities, so that noise can be below the unit of time

class Search {
public:
  Search(TaskGraph const &graph, Network const &network, Units const &units, std::vector<char> const &is_dummy,
         Time enough)
      : graph_(graph),
        network_(network),
        reversed_(reversed(network)),
        units_(units),
        is_dummy_(is_dummy),
        enough_(enough),
        forward_(network_, units, is_dummy_),
        backward_(reversed_, units, is_dummy_) {}

  void try_lists() {
    for (bool const from_end : {false, true}) {
      Timetable table;
      Time const found = run(from_end, paths(from_end), nullptr, table);
      keep(table, justify(table, found));
      if (graph_.size() > 20'000) return;
    }
  }

  void improve(std::size_t steps, std::uint64_t seed) {
    Random random(seed);
    Timetable current = best_, table;
    Time current_length = length_;
    Time const longest = *std::ranges::max_element(network_.duration) + units_.communication;
    std::vector<Time> const path[] = {paths(false), paths(true)};
    for (std::size_t step = 0; step < steps && length_ > enough_; ++step) {
      bool const from_end = random.below(2) != 0;
      std::vector<Time> priority =
          random.below(4) == 0 ? path[from_end] : distances_from(from_end, current, current_length);
      auto const noise = static_cast<std::uint64_t>(std::max(Time{1}, (scale * longest << random.below(5)) / 4));
      for (Time &each : priority) each += static_cast<Time>(random.below(noise));
      Time found = run(from_end, priority, nullptr, table);
      found = justify(table, found);
      keep(table, found);
      if (found > current_length) continue;
      current_length = found;
      std::swap(current, table);
    }
  }

  Time length() const { return length_; }
  Timetable const &best() const { return best_; }

private:
  // Longest path from each task's begin, or to its end, with communication.
  std::vector<Time> paths(bool from_end) const {
    Network const &net = from_end ? network_ : reversed_;
    std::vector<Time> result(net.size());
    for_each_in_order(net, [&](TaskId task) {
      for (TaskId other : net.before.of(task))
        result[task] = std::max(
            result[task], result[other] + (is_dummy_[other] || is_dummy_[task] ? 0 : scale * units_.communication));
      result[task] += scale * net.duration[task];
    });
    return result;
  }

  // Priorities that reproduce the order of a timetable, from its begin or its end.
  std::vector<Time> distances_from(bool end, Timetable const &table, Time length) const {
    std::vector<Time> result(table.start.size());
    for (TaskId task = 0; task < result.size(); ++task)
      result[task] = scale * (end ? table.start[task] + network_.duration[task] : length - table.start[task]);
    return result;
  }

  Time run(bool from_end, std::vector<Time> const &priority, std::vector<std::uint32_t> const *fixed,
           Timetable &table) {
    Time const found = (from_end ? backward_ : forward_).run(priority, fixed, table);
    if (from_end)
      for (TaskId task = 0; task < table.start.size(); ++task)
        table.start[task] = found - table.start[task] - network_.duration[task];
    return found;
  }

  // Shifts all tasks to the latest and then to the earliest time, on fixed units, until the length stops falling.
  Time justify(Timetable &table, Time length) {
    for (Time before = length + 1; length < before && length > enough_;) {
      before = length;
      for (bool const from_end : {true, false}) {
        std::vector<std::uint32_t> const unit = table.unit;
        length = run(from_end, distances_from(from_end, table, length), &unit, table);
      }
    }
    return length;
  }

  void keep(Timetable const &table, Time found) {
    if (!best_.start.empty() && found >= length_) return;
    best_ = table;
    length_ = found;
  }

  TaskGraph const &graph_;
  Network const &network_;
  Network const reversed_;
  Units const &units_;
  std::vector<char> const &is_dummy_;
  Time enough_;
  UnitChooser forward_, backward_;
  Timetable best_;
  Time length_ = 0;
};

} // namespace

Solution schedule_communicating(TaskGraph const &graph, Units const &units, Effort const &effort) {
  Network const network = make_network(graph);
  Windows const window = windows(network, units);
  std::vector<char> const is_dummy = dummies(graph);
  Solution result;
  result.bounds = bounds(network, units, window, graph.size() > most_searched_tasks ? 1'000'000 : 5'000'000);
  result.at_least = result.bounds.best();
  Search search(graph, network, units, is_dummy, result.at_least);
  search.try_lists();
  search.improve(effort.search_steps(graph.size(), 1 + units.total() / 16), effort.seed);
  result.timetable = search.best();
  result.length = search.length();
  if (result.is_optimal()) return result;
  if (std::uint64_t const nodes = effort.exact_nodes(graph.size())) {
    ExactTimetable exact =
        search_communicating(network, units, is_dummy, window.tail, result.length, result.at_least, nodes);
    if (!exact.timetable.start.empty()) {
      result.timetable = std::move(exact.timetable);
      result.length = length(graph, result.timetable.start);
    }
    if (exact.is_complete) result.at_least = result.length;
  }
  return result;
}

} // namespace symreal
