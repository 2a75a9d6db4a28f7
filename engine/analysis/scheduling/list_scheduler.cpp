#include "engine/analysis/scheduling/list_scheduler.h"

#include <algorithm>

namespace symreal {

void ListScheduler::make_ready(TaskId task) {
  if (network_.duration[task] == 0)
    instant_.push_back(task);
  else
    ready_[network_.kind[task]].push({priority_[task], task});
}

void ListScheduler::end_task(TaskId task) {
  for (TaskId after : network_.after.of(task))
    if (--waits_for_[after] == 0) make_ready(after);
  while (!instant_.empty()) {
    TaskId const next = instant_.back();
    instant_.pop_back();
    (*start_)[next] = now_;
    for (TaskId after : network_.after.of(next))
      if (--waits_for_[after] == 0) make_ready(after);
  }
}

Time ListScheduler::run(std::span<Time const> priority, std::vector<Time> &start) {
  priority_ = priority;
  start_ = &start;
  now_ = 0;
  start.assign(network_.size(), 0);
  ready_.resize(units_.count.size());
  waits_for_.resize(network_.size());
  std::vector<TaskId> first;
  for (TaskId task = 0; task < network_.size(); ++task) {
    waits_for_[task] = static_cast<std::uint32_t>(network_.before.of(task).size());
    if (waits_for_[task] == 0) first.push_back(task);
  }
  for (TaskId task : first) {
    if (network_.duration[task] == 0)
      end_task(task);
    else
      make_ready(task);
  }
  std::vector<unsigned> free = units_.count;
  while (true) {
    for (std::size_t kind = 0; kind < free.size(); ++kind)
      for (; free[kind] != 0 && !ready_[kind].empty(); --free[kind]) {
        TaskId const task = ready_[kind].top().task;
        ready_[kind].pop();
        start[task] = now_;
        running_.push({now_ + network_.duration[task], task});
      }
    if (running_.empty()) return now_;
    now_ = running_.top().at;
    while (!running_.empty() && running_.top().at == now_) {
      TaskId const task = running_.top().task;
      running_.pop();
      ++free[network_.kind[task]];
      end_task(task);
    }
  }
}

} // namespace symreal
