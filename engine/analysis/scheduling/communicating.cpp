#include "engine/analysis/scheduling/communicating.h"

#include "engine/analysis/scheduling/exact.h"
#include "engine/analysis/scheduling/list_scheduler.h"
#include "engine/analysis/scheduling/random.h"
#include "engine/analysis/scheduling/search_states.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace symreal {

namespace {

constexpr Time scale = 16; // of priorities, so that noise can be below the unit of time

class ListSearch {
public:
  ListSearch(TaskGraph const &graph, Network const &network, Units const &units, std::vector<char> const &is_dummy,
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

class ExactSearch {
public:
  ExactSearch(Network const &network, Units const &units, std::vector<char> const &is_dummy,
              std::vector<Time> const &tail, Time below, Time enough, std::uint64_t most_nodes)
      : network_(network),
        units_(units),
        is_dummy_(is_dummy),
        tail_(tail),
        best_length_(below),
        enough_(enough),
        most_nodes_(most_nodes),
        count_(static_cast<TaskId>(network.size())),
        seen_(16),
        free_(units.total()),
        has_work_(units.total()),
        now_{{}, std::vector<std::uint32_t>(network.size())},
        head_(network.size()),
        before_(network.size()),
        after_(network.size()),
        by_tail_(network.size()) {
    now_.start.resize(count_);
    for (TaskId task = 0; task < count_; ++task) {
      for (TaskId other : network.before.of(task)) before_[task] |= set_of(other);
      for (TaskId other : network.after.of(task)) after_[task] |= set_of(other);
    }
    std::iota(by_tail_.begin(), by_tail_.end(), TaskId{0});
    std::ranges::sort(by_tail_, std::greater<>(), [&](TaskId task) { return std::pair(tail[task], task); });
  }

  ExactTimetable run() {
    enter(0, 0);
    return {best_, !is_over_limit_};
  }

private:
  bool is_placed(TaskId task) const { return placed_ >> task & 1; }
  bool is_ready(TaskId task) const { return !is_placed(task) && (before_[task] & ~placed_) == 0; }
  Time end_of(TaskId task) const { return now_.start[task] + network_.duration[task]; }

  // Earliest start on a unit of a task whose predecessors are placed.
  Time earliest(TaskId task, std::uint32_t unit) const {
    Time at = network_.duration[task] == 0 ? 0 : free_[unit];
    for (TaskId other : network_.before.of(task)) {
      bool const moved = now_.unit[other] != unit && !is_dummy_[task] && !is_dummy_[other];
      at = std::max(at, end_of(other) + (moved ? units_.communication : 0));
    }
    return at;
  }

  // Visits a node of the search; later tasks begin at `last` or later.
  void enter(Time last, Time length) {
    if (++nodes_ > most_nodes_) is_over_limit_ = true;
    if (is_over_limit_ || best_length_ <= enough_ || is_hopeless(last)) return;
    if (placed_ == (count_ == 64 ? ~TaskSet{0} : set_of(count_) - 1)) {
      if (length < best_length_) best_ = now_, best_length_ = length;
      return;
    }
    if (seen_.was_seen(key(last), last)) return;
    struct Branch {
      Time start;
      TaskId task;
      std::uint32_t unit;
    };
    std::vector<Branch> branches;
    for (TaskId task = 0; task < count_; ++task) {
      if (!is_ready(task)) continue;
      std::uint32_t const first = units_.first_of(network_.kind[task]);
      std::uint32_t const end = is_dummy_[task] ? first + 1 : first + units_.count[network_.kind[task]];
      for (std::uint32_t unit = first; unit < end; ++unit) {
        if (Time const start = earliest(task, unit); is_dummy_[task] || start >= last)
          branches.push_back({start, task, unit});
        if (!has_work_[unit]) break;
      }
    }
    std::ranges::sort(branches, {}, [&](Branch const &b) {
      return std::tuple(!is_dummy_[b.task], b.start, -tail_[b.task] - network_.duration[b.task], b.task, b.unit);
    });
    for (Branch const &branch : branches) {
      follow(branch.task, branch.unit, branch.start, last, length);
      if (is_dummy_[branch.task]) return; // its unit is irrelevant, so placing it now is optimal
    }
  }

  void follow(TaskId task, std::uint32_t unit, Time start, Time last, Time length) {
    bool const takes_time = network_.duration[task] != 0;
    Time const free = free_[unit];
    char const had_work = has_work_[unit];
    now_.start[task] = start;
    now_.unit[task] = unit;
    placed_ |= set_of(task);
    if (!is_dummy_[task]) has_work_[unit] = 1;
    if (takes_time) free_[unit] = end_of(task);
    enter(is_dummy_[task] ? last : start, std::max(length, end_of(task)));
    placed_ &= ~set_of(task);
    free_[unit] = free;
    has_work_[unit] = had_work;
  }

  // State of each unit relevant to the rest; the sum makes it independent of the order of a kind's units.
  StateKey key(Time last) const {
    StateKey result;
    result.add(placed_);
    for (std::size_t kind = 0; kind < units_.count.size(); ++kind) {
      std::uint64_t low = 0, high = 0;
      for (std::uint32_t unit = units_.first_of(kind); unit < units_.first_of(kind) + units_.count[kind]; ++unit) {
        StateKey part;
        part.add(static_cast<std::uint64_t>(std::max(free_[unit] - last, Time{0})));
        part.add(static_cast<std::uint64_t>(has_work_[unit]));
        for (TaskId task = 0; task < count_; ++task) {
          if (!is_placed(task) || now_.unit[task] != unit || (after_[task] & ~placed_) == 0) continue;
          part.add(task);
          part.add(static_cast<std::uint64_t>(std::max(end_of(task) + units_.communication - last, Time{0})));
        }
        low += part.low();
        high += part.high();
      }
      result.add(low);
      result.add(high);
    }
    return result;
  }

  bool is_hopeless(Time last) {
    for (TaskId task = 0; task < count_; ++task) {
      if (is_placed(task)) {
        if (end_of(task) + tail_[task] >= best_length_) return true;
        continue;
      }
      head_[task] = is_dummy_[task] ? 0 : last;
      for (TaskId other : network_.before.of(task))
        head_[task] = std::max(head_[task], is_placed(other) ? end_of(other) : head_[other] + network_.duration[other]);
      if (is_ready(task) && !is_dummy_[task]) head_[task] = std::max(head_[task], earliest_of_all(task));
      if (head_[task] + network_.duration[task] + tail_[task] >= best_length_) return true;
    }
    for (std::size_t kind = 0; kind < units_.count.size(); ++kind)
      if (is_too_much(kind, last)) return true;
    return false;
  }

  Time earliest_of_all(TaskId task) const {
    Time best = std::numeric_limits<Time>::max();
    std::uint32_t const first = units_.first_of(network_.kind[task]);
    for (std::uint32_t unit = first; unit < first + units_.count[network_.kind[task]]; ++unit)
      best = std::min(best, earliest(task, unit));
    return best;
  }

  // Whether the remaining work exceeds the capacity between now and the tails.
  bool is_too_much(std::size_t kind, Time last) const {
    Time work = 0;
    for (std::uint32_t unit = units_.first_of(kind); unit < units_.first_of(kind) + units_.count[kind]; ++unit)
      work += std::max(free_[unit], last);
    for (TaskId task : by_tail_) {
      if (is_placed(task) || network_.kind[task] != kind || network_.duration[task] == 0) continue;
      work += network_.duration[task];
      if (work > static_cast<Time>(units_.count[kind]) * (best_length_ - 1 - tail_[task])) return true;
    }
    return false;
  }

  Network const &network_;
  Units const &units_;
  std::vector<char> const &is_dummy_;
  std::vector<Time> const &tail_;
  Time best_length_, enough_;
  std::uint64_t most_nodes_, nodes_ = 0;
  bool is_over_limit_ = false;
  TaskId count_;
  TaskSet placed_ = 0;
  SeenStates seen_;
  std::vector<Time> free_;
  std::vector<char> has_work_; // per unit
  Timetable now_, best_;
  std::vector<Time> head_;
  std::vector<TaskSet> before_, after_;
  std::vector<TaskId> by_tail_;
};

} // namespace

Solution schedule_communicating(TaskGraph const &graph, Units const &units, Effort const &effort) {
  Network const network = make_network(graph);
  Windows const window = windows(network, units);
  std::vector<char> const is_dummy = dummies(graph);
  Solution result;
  result.bounds = bounds(network, units, window, graph.size() > most_searched_tasks ? 1'000'000 : 5'000'000);
  result.at_least = result.bounds.best();
  ListSearch search(graph, network, units, is_dummy, result.at_least);
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

ExactTimetable search_communicating(Network const &network, Units const &units, std::vector<char> const &is_dummy,
                                    std::vector<Time> const &tail, Time below, Time enough, std::uint64_t most_nodes) {
  return ExactSearch(network, units, is_dummy, tail, below, enough, most_nodes).run();
}

} // namespace symreal
