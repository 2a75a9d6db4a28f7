#include "engine/analysis/scheduling/bounds.h"

#include <algorithm>

namespace symreal {

namespace {

std::vector<Time> heads(Network const &network, Units const &units) {
  if (network.size() > most_tasks_with_ancestors) return longest_paths(network);
  Ancestors const ancestors(network);
  std::vector<Time> head(network.size());
  std::vector<TaskId> done; // descending by head
  for_each_in_order(network, [&](TaskId task) {
    for (TaskId before : network.before.of(task))
      head[task] = std::max(head[task], head[before] + network.duration[before]);
    std::vector<Time> work(units.count.size()); // per kind: of ancestors with at least the current head
    for (TaskId other : done) {
      if (!ancestors.has(task, other)) continue;
      std::size_t const kind = network.kind[other];
      work[kind] += network.duration[other];
      head[task] = std::max(head[task], head[other] + shared(work[kind], units.count[kind]));
    }
    done.insert(std::ranges::upper_bound(done, head[task], std::greater<>(), [&](TaskId other) { return head[other]; }),
                task);
  });
  return head;
}

// Interval bound for one kind of unit, over intervals from time a to c before the end. In them a task with head h,
// duration d and tail t spends at least min(d, h + d - a, t + d - c, L - a - c), where L is the length. As c falls from
// min(t + d, L - a), this grows linearly until it reaches min(d, h + d - a).
class IntervalWork {
public:
  IntervalWork(Network const &network, Windows const &windows, std::size_t kind, unsigned units)
      : network_(network),
        windows_(windows),
        units_(units) {
    for (TaskId task = 0; task < network.size(); ++task)
      if (network.kind[task] == kind && network.duration[task] != 0) tasks_.push_back(task);
  }

  // Relevant interval begins, at which the growth of the work changes; at most `most` of them.
  std::vector<Time> begins(std::size_t most) const {
    std::vector<Time> all = {0};
    for (TaskId task : tasks_) {
      all.push_back(windows_.head[task]);
      all.push_back(windows_.head[task] + network_.duration[task]);
    }
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    if (all.size() <= most) return all;
    std::vector<Time> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
    return some;
  }

  // Least length, at least `length`, that intervals beginning at `begin` do not rule out.
  Time bound(Time begin, Time length) {
    changes_.clear();
    for (TaskId task : tasks_) {
      Time const duration = network_.duration[task];
      Time const within = std::min(duration, windows_.head[task] + duration - begin);
      Time const from = std::min(windows_.tail[task] + duration, length - begin);
      if (within <= 0 || from <= 0) continue;
      changes_.push_back({from, 1});
      changes_.push_back({std::max(from - within, Time{0}), -1});
    }
    std::ranges::sort(changes_, [](Change const &a, Change const &b) { return a.at > b.at; });
    Time work = 0, growth = 0, at = length, best = length;
    for (Change const &change : changes_) {
      work += growth * (at - change.at);
      at = change.at;
      best = std::max(best, begin + at + shared(work, units_));
      growth += change.growth;
    }
    return best;
  }

private:
  struct Change {
    Time at, growth;
  };
  Network const &network_;
  Windows const &windows_;
  Time units_;
  std::vector<TaskId> tasks_;
  std::vector<Change> changes_;
};

} // namespace

Windows windows(Network const &network, Units const &units) {
  return {heads(network, units), heads(reversed(network), units)};
}

Time Bounds::best() const { return std::max({critical_path, work, interval}); }

Time critical_path(Network const &network) {
  std::vector<Time> const head = longest_paths(network);
  Time result = 0;
  for (TaskId task = 0; task < network.size(); ++task) result = std::max(result, head[task] + network.duration[task]);
  return result;
}

Time work_bound(Network const &network, Units const &units) {
  std::vector<Time> work(units.count.size());
  for (TaskId task = 0; task < network.size(); ++task) work[network.kind[task]] += network.duration[task];
  Time best = 0;
  for (std::size_t kind = 0; kind < work.size(); ++kind)
    if (work[kind] != 0) best = std::max(best, shared(work[kind], units.count[kind]));
  return best;
}

Bounds bounds(Network const &network, Units const &units, Windows const &windows, std::size_t effort) {
  Bounds result;
  result.critical_path = critical_path(network);
  for (TaskId task = 0; task < network.size(); ++task)
    result.interval = std::max(result.interval, windows.head[task] + network.duration[task] + windows.tail[task]);
  result.work = work_bound(network, units);
  result.interval = result.best();
  for (std::size_t kind = 0; kind < units.count.size(); ++kind) {
    IntervalWork work(network, windows, kind, units.count[kind]);
    std::vector<Time> const begins = work.begins(std::max<std::size_t>(effort / (network.size() + 1), 8));
    for (Time before = -1; before < result.interval;) {
      before = result.interval;
      for (Time begin : begins) result.interval = work.bound(begin, result.interval);
    }
  }
  return result;
}

} // namespace symreal
