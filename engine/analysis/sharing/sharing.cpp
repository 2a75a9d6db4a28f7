#include "engine/analysis/sharing/sharing.h"

#include "engine/analysis/levels/levels.h"
#include "engine/plan/schedule/dependences.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace symreal {

namespace {

class StatementReader {
public:
  StatementReader(Plan const &plan, Costs const &costs)
      : plan_(plan),
        body_(plan.compute()),
        costs_(costs),
        task_(body_.regions.value_count(), no_node),
        path_(body_.regions.value_count(), 0) {}

  StatementTasks run() {
    StatementTasks result;
    for (std::size_t k = 0; k < body_.variables.size(); ++k) {
      add_costs(body_.variables[k]);
      std::vector<TaskId> before;
      for_each_before(
          plan_, body_, k, [&](NodeId id) { return is_task(id); }, [&](NodeId id) { before.push_back(task_[id]); });
      task_[body_.variables[k]] = static_cast<TaskId>(k);
      result.tasks.add(std::llround(throughput_ * StatementTasks::scale), before);
      result.latency.push_back(latency_ * StatementTasks::scale / costs_.scale);
    }
    result.is_result.assign(body_.variables.size(), 0);
    auto const mark = [&](NodeId use) {
      for_each_read(
          *plan_.graph, use, [&](NodeId id) { return is_task(id); },
          [&](NodeId id) { return is_read(plan_, body_.kind, id); },
          [&](NodeId id) { result.is_result[task_[id]] = 1; });
    };
    std::ranges::for_each(body_.results, mark);
    for (Check const &check : body_.checks) mark(check.condition);
    return result;
  }

private:
  bool is_task(NodeId id) const { return task_[id] != no_node; }
  bool is_nested(NodeId id) const { return id != no_node && !is_task(id) && !is_read(plan_, body_.kind, id); }

  // Sums the costs of the operations in the expression, innermost first, since operands have smaller ids.
  void add_costs(NodeId variable) {
    throughput_ = 0;
    latency_ = 0;
    if (body_.regions.is_gate(variable) || is_read(plan_, body_.kind, variable)) return;
    std::vector<NodeId> nested = {variable};
    for (std::size_t k = 0; k < nested.size(); ++k)
      for (NodeId operand : operands(nested[k]))
        if (is_nested(operand)) nested.push_back(operand);
    std::ranges::sort(nested);
    for (NodeId id : nested) {
      auto const op = static_cast<std::size_t>(plan_.graph->nodes[id].op);
      Time longest = 0;
      for (NodeId operand : operands(id))
        if (is_nested(operand)) longest = std::max(longest, path_[operand]);
      path_[id] = longest + costs_.latency[op];
      throughput_ += costs_.throughput[op];
    }
    latency_ = path_[variable];
  }

  // Operands without the preceding call, which only orders calls.
  std::span<NodeId const> operands(NodeId id) const {
    Node const &node = plan_.graph->nodes[id];
    return {node.operand.data(), node.op == Op::call_in_order ? 2 : node.operand.size()};
  }

  Plan const &plan_;
  PlanFunction const &body_;
  Costs const &costs_;
  std::vector<TaskId> task_; // statement that defines the value
  std::vector<Time> path_;   // per nested operation, in parts of the costs' unit
  double throughput_ = 0;
  Time latency_ = 0;
};

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
    largest_ = std::max(largest_, work_of_[root(parent_, task)]);
  }

  Time alone() const { return std::max(work_, path_); }
  // Time if the connected sets could be balanced perfectly.
  Time at_best(unsigned threads) const { return std::max({work_ / threads, largest_, path_}); }

  // Distributes the sets, largest first, each to the thread with the least work. Returns the time.
  Time share_out(unsigned threads, std::vector<Share> &shares) {
    std::vector<TaskId> sets;
    for (TaskId task : tasks_)
      if (root(parent_, task) == task) sets.push_back(task);
    std::ranges::stable_sort(sets, [&](TaskId a, TaskId b) { return work_of_[a] > work_of_[b]; });
    std::vector<Time> load(threads);
    for (TaskId set : sets) {
      auto const least = std::ranges::min_element(load);
      *least += work_of_[set];
      shares[set].thread = static_cast<std::uint32_t>(least - load.begin());
    }
    for (TaskId task : tasks_) shares[task].thread = shares[root(parent_, task)].thread;
    return std::max(*std::ranges::max_element(load), path_);
  }

  std::vector<TaskId> const &tasks() const { return tasks_; }

private:
  static constexpr TaskId none = ~TaskId{0};

  void unite(TaskId a, TaskId b) {
    a = root(parent_, a);
    b = root(parent_, b);
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

constexpr double at_once = 8; // numbers per cache line

// Topological orders of the statements: the given one, by earliest start, and by latest start.
std::vector<std::vector<TaskId>> orders(StatementTasks const &statements) {
  TaskGraph waiting = statements.tasks;
  waiting.duration = statements.latency;
  Levels const level = levels(waiting);
  std::vector<TaskId> plain(waiting.size());
  std::iota(plain.begin(), plain.end(), TaskId{0});
  std::vector<std::vector<TaskId>> result(3, plain);
  std::ranges::stable_sort(result[1], {}, [&](TaskId task) { return level.earliest[task]; });
  std::ranges::stable_sort(result[2], {}, [&](TaskId task) { return level.latest[task]; });
  return result;
}

// Number of stages that several threads execute.
std::size_t shared_stages(std::vector<Share> const &shares) {
  std::vector<std::uint32_t> stages;
  for (Share const &share : shares)
    if (share.thread != 0) stages.push_back(share.stage);
  std::ranges::sort(stages);
  return static_cast<std::size_t>(std::ranges::unique(stages).begin() - stages.begin());
}

// Execution time, where a thread's part of a stage takes the larger of its work and its longest path.
class Clock {
public:
  Clock(StatementTasks const &statements, unsigned threads) : statements_(statements), threads_(threads) {}

  // Sum over stages of the slowest part.
  double time(std::vector<Share> const &shares) const {
    TaskGraph const &tasks = statements_.tasks;
    std::size_t const stages = shares.empty() ? 0 : std::ranges::max(shares, {}, &Share::stage).stage + std::size_t{1};
    std::vector<Time> end(tasks.size()), work(stages * threads_), longest(stages * threads_);
    auto const part = [&](TaskId task) { return shares[task].stage * std::size_t{threads_} + shares[task].thread; };
    for (TaskId task = 0; task < tasks.size(); ++task) {
      for (TaskId before : tasks.predecessors(task))
        if (part(before) == part(task)) end[task] = std::max(end[task], end[before]);
      end[task] += statements_.latency[task];
      work[part(task)] += tasks.duration[task];
      longest[part(task)] = std::max(longest[part(task)], end[task]);
    }
    Time sum = 0;
    for (std::size_t stage = 0; stage < stages; ++stage) {
      Time slowest = 0;
      for (std::size_t k = stage * threads_; k < (stage + 1) * threads_; ++k)
        slowest = std::max({slowest, work[k], longest[k]});
      sum += slowest;
    }
    return static_cast<double>(sum) / StatementTasks::scale;
  }

private:
  StatementTasks const &statements_;
  unsigned threads_;
};

// Number of values that are results or that another part reads.
std::size_t crossing(StatementTasks const &statements, std::vector<Share> const &shares) {
  auto const same = [&](TaskId a, TaskId b) {
    return shares[a].stage == shares[b].stage && shares[a].thread == shares[b].thread;
  };
  std::vector<char> crosses = statements.is_result;
  for (TaskId task = 0; task < shares.size(); ++task)
    for (TaskId before : statements.tasks.predecessors(task)) crosses[before] |= !same(before, task);
  return static_cast<std::size_t>(std::ranges::count(crosses, 1));
}

} // namespace

StatementTasks statement_tasks(Plan const &plan, Costs const &costs) { return StatementReader(plan, costs).run(); }

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

Sharing share_out(Plan const &plan, StatementTasks const &statements, Costs const &costs, unsigned threads) {
  TaskGraph const &tasks = statements.tasks;
  internal_check(tasks.size() == plan.compute().variables.size());
  double const meeting = costs.threads->sections_for(threads);
  Clock const clock(statements, threads);
  Sharing result{threads};
  for (std::vector<TaskId> const &order : orders(statements)) {
    Sharing one{threads, sliced(statements, order, threads, std::llround(meeting * StatementTasks::scale))};
    one.stages = shared_stages(one.shares);
    one.computing = clock.time(one.shares);
    one.meeting = static_cast<double>(one.stages) * meeting;
    one.crossing = one.stages == 0 ? 0 : crossing(statements, one.shares);
    one.moving = static_cast<double>(one.crossing) / at_once * costs.threads->hand_over;
    if (result.shares.empty() || one.together() < result.together()) result = std::move(one);
  }
  result.one_thread = clock.time(std::vector<Share>(tasks.size()));
  return result;
}

} // namespace symreal
