#include "engine/analysis/levels/levelled.h"

#include "engine/analysis/levels/ready_tasks.h"
#include "engine/diagnostics/diagnostic.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <queue>

namespace symreal {

namespace {

using Ending = std::pair<Time, TaskId>;

class Machine {
public:
  Machine(TaskGraph const &graph, Levels const &levels)
      : graph_(graph),
        levels_(levels),
        successors_(successors(graph)) {}

  // Start times; nullopt if a task would begin too late for the end to be within `length`.
  std::optional<std::vector<Time>> run(std::uint32_t units, Time length) {
    start_.assign(graph_.size(), 0);
    missing_.resize(graph_.size());
    ReadyTasks ready(graph_.size(), levels_.span);
    running_ = {};
    for (TaskId task = 0; task < graph_.size(); ++task) {
      missing_[task] = static_cast<std::uint32_t>(graph_.predecessors(task).size());
      if (missing_[task] == 0) fresh_.push_back(task);
    }
    admit(0, ready);
    for (Time now = 0; !ready.empty() || !running_.empty();) {
      while (!ready.empty() && running_.size() < units) {
        TaskId const task = ready.pop();
        if (now - levels_.latest[task] > length - levels_.span) return {};
        start_[task] = now;
        running_.emplace(now + graph_.duration[task], task);
      }
      now = running_.top().first;
      while (!running_.empty() && running_.top().first == now) {
        finish(running_.top().second);
        running_.pop();
      }
      admit(now, ready);
    }
    return std::move(start_);
  }

private:
  void finish(TaskId task) {
    for (TaskId next : successors_.of(task))
      if (--missing_[next] == 0) fresh_.push_back(next);
  }

  // Makes tasks without missing predecessors ready, or finishes them if their duration is 0.
  void admit(Time now, ReadyTasks &ready) {
    while (!fresh_.empty()) {
      TaskId const task = fresh_.back();
      fresh_.pop_back();
      if (graph_.duration[task] != 0) {
        ready.push(levels_.latest[task], task);
        continue;
      }
      start_[task] = now;
      finish(task);
    }
  }

  TaskGraph const &graph_;
  Levels const &levels_;
  Successors successors_;
  std::vector<Time> start_;
  std::vector<std::uint32_t> missing_; // per task: predecessors that have not ended
  std::vector<TaskId> fresh_;
  std::priority_queue<Ending, std::vector<Ending>, std::greater<>> running_;
};

Levelled finished(TaskGraph const &graph, std::vector<Time> start) {
  Levelled result{std::move(start)};
  result.length = length(graph, result.start);
  result.peak = peak(profile(graph, result.start, result.length));
  return result;
}

} // namespace

Levelled level_for_units(TaskGraph const &graph, Levels const &levels, std::uint32_t units) {
  // A task waits at most for all other tasks.
  auto start = Machine(graph, levels).run(units, levels.span + levels.work);
  if (!start) internal_failure("a list is never longer than all its tasks", __FILE__, __LINE__);
  return finished(graph, std::move(*start));
}

Levelled level_for_length(TaskGraph const &graph, Levels const &levels, LevelBounds const &bounds, Time length) {
  Levelled best = finished(graph, levels.earliest);
  if (Levelled late = finished(graph, levels.latest); late.peak < best.peak) best = std::move(late);
  // Stops within one percent of the optimal units if each run is long.
  constexpr std::size_t large = 1'000'000;
  std::uint32_t too_few = std::max(bounds.units(length), 1U) - 1, step = 1;
  std::uint32_t const close = graph.size() < large ? 1 : std::max(too_few / 100, 1U);
  Machine machine(graph, levels);
  bool is_found = false;
  while (best.peak > too_few + close) {
    std::uint32_t const units = is_found ? (too_few + best.peak) / 2 : std::min(too_few + step, best.peak - 1);
    if (auto start = machine.run(units, length)) {
      best = finished(graph, std::move(*start));
      is_found = true;
    } else {
      too_few = units;
      step *= 2;
    }
  }
  return best;
}

} // namespace symreal
