#include "engine/analysis/sharing/slices.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace symreal {

namespace {

constexpr std::size_t most_cuts = 64; // possible cut points

// Tasks of a slice, and their connected sets by union-find.
class Slice {
public:
  explicit Slice(StatementTasks const &statements)
      : statements_(statements),
        parent_(statements.tasks.size(), none),
        work_of_(parent_.size()),
        end_(parent_.size()) {}

  void clear() {
    for (TaskId task : tasks_) parent_[task] = none;
    tasks_.clear();
    work_ = largest_ = path_ = 0;
  }

  void add(TaskId task) {
    tasks_.push_back(task);
    parent_[task] = task;
    work_of_[task] = statements_.tasks.duration[task];
    end_[task] = 0;
    for (TaskId before : statements_.tasks.predecessors(task))
      if (parent_[before] != none) {
        end_[task] = std::max(end_[task], end_[before]);
        unite(before, task);
      }
    end_[task] += statements_.latency[task];
    path_ = std::max(path_, end_[task]);
    work_ += statements_.tasks.duration[task];
    largest_ = std::max(largest_, work_of_[root(task)]);
  }

  Time alone() const { return std::max(work_, path_); }
  // Time if the connected sets could be balanced perfectly.
  Time at_best(unsigned threads) const { return std::max({work_ / threads, largest_, path_}); }

  // Distributes the sets, largest first, each to the thread with the least work. Returns the time.
  Time share_out(unsigned threads, std::vector<Share> &shares) {
    std::vector<TaskId> sets;
    for (TaskId task : tasks_)
      if (root(task) == task) sets.push_back(task);
    std::ranges::stable_sort(sets, [&](TaskId a, TaskId b) { return work_of_[a] > work_of_[b]; });
    std::vector<Time> load(threads);
    for (TaskId set : sets) {
      auto const least = std::ranges::min_element(load);
      *least += work_of_[set];
      shares[set].thread = static_cast<std::uint32_t>(least - load.begin());
    }
    for (TaskId task : tasks_) shares[task].thread = shares[root(task)].thread;
    return std::max(*std::ranges::max_element(load), path_);
  }

  std::vector<TaskId> const &tasks() const { return tasks_; }

private:
  static constexpr TaskId none = ~TaskId{0};

  TaskId root(TaskId task) {
    while (parent_[task] != task) task = parent_[task] = parent_[parent_[task]];
    return task;
  }
  void unite(TaskId a, TaskId b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    if (work_of_[a] < work_of_[b]) std::swap(a, b);
    parent_[b] = a;
    work_of_[a] += work_of_[b];
  }

  StatementTasks const &statements_;
  std::vector<TaskId> tasks_, parent_;
  std::vector<Time> work_of_, end_; // per root: work of its set; per task: end relative to the slice's begin
  Time work_ = 0, largest_ = 0, path_ = 0;
};

// Possible cut points, spaced evenly by work.
std::vector<std::size_t> places(StatementTasks const &statements, std::vector<TaskId> const &order) {
  std::vector<Time> const &duration = statements.tasks.duration;
  Time const all = std::accumulate(duration.begin(), duration.end(), Time{0});
  std::vector<std::size_t> result = {0};
  Time done = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    done += duration[order[k]];
    bool const is_place = order.size() <= most_cuts || done >= all / Time{most_cuts} * static_cast<Time>(result.size());
    if (is_place || k + 1 == order.size()) result.push_back(k + 1);
  }
  return result;
}

// For each cut point, the begin of the best slice that ends there.
std::vector<std::size_t> best_cuts(Slice &slice, std::vector<TaskId> const &order,
                                   std::vector<std::size_t> const &place, unsigned threads, Time meeting) {
  std::vector<Time> best(place.size(), std::numeric_limits<Time>::max());
  std::vector<std::size_t> from(place.size());
  best[0] = 0;
  for (std::size_t begin = 0; begin + 1 < place.size(); ++begin) {
    slice.clear();
    for (std::size_t end = begin + 1; end < place.size(); ++end) {
      for (std::size_t k = place[end - 1]; k < place[end]; ++k) slice.add(order[k]);
      Time const time = best[begin] + std::min(slice.alone(), meeting + slice.at_best(threads));
      if (time >= best[end]) continue;
      best[end] = time;
      from[end] = begin;
    }
  }
  slice.clear();
  return from;
}

} // namespace

std::vector<Share> sliced(StatementTasks const &statements, std::vector<TaskId> const &order, unsigned threads,
                          Time meeting) {
  std::vector<std::size_t> const place = places(statements, order);
  Slice slice(statements);
  std::vector<std::size_t> const from = best_cuts(slice, order, place, threads, meeting);
  std::vector<std::size_t> cuts = {place.size() - 1};
  while (cuts.back() != 0) cuts.push_back(from[cuts.back()]);
  std::ranges::reverse(cuts);
  std::vector<Share> shares(order.size());
  std::uint32_t stage = 0;
  bool was_shared = true;
  for (std::size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
    slice.clear();
    for (std::size_t k = place[cuts[cut]]; k < place[cuts[cut + 1]]; ++k) slice.add(order[k]);
    bool const is_shared = meeting + slice.share_out(threads, shares) < slice.alone();
    if (cut != 0 && (is_shared || was_shared)) ++stage;
    was_shared = is_shared;
    for (TaskId task : slice.tasks()) shares[task] = {stage, is_shared ? shares[task].thread : 0};
  }
  return shares;
}

} // namespace symreal
