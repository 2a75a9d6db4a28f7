#include "engine/analysis/sharing/sharing.h"

#include "engine/analysis/levels/levels.h"
#include "engine/analysis/sharing/slices.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace symreal {

namespace {

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

Sharing share_out(Schedule const &plan, StatementTasks const &statements, Costs const &costs, unsigned threads) {
  TaskGraph const &tasks = statements.tasks;
  internal_check(tasks.size() == plan.compute.variables.size());
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
