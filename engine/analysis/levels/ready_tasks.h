// Priority queue of ready tasks by latest start.
//
// Method: a list per time, and above the lists a pyramid of bits: a bit tells whether anything is below it, and 64 bits
// form a word. Finding the first list takes one step per level of the pyramid; a heap of millions of tasks is several
// times slower.
#pragma once

#include "engine/analysis/tasks/task_graph.h"

#include <bit>

namespace symreal {

class ReadyTasks {
public:
  // `tasks` is the number of tasks, `last` the greatest latest start.
  ReadyTasks(std::size_t tasks, Time last) : first_(static_cast<std::size_t>(last) + 1, none), next_(tasks) {
    for (std::size_t size = first_.size(); pyramid_.empty() || size > 1;) {
      size = (size + 63) / 64;
      pyramid_.emplace_back(size);
    }
  }

  bool empty() const { return pyramid_.back()[0] == 0; }

  void push(Time time, TaskId task) {
    auto at = static_cast<std::size_t>(time);
    next_[task] = first_[at];
    first_[at] = task;
    for (std::vector<std::uint64_t> &level : pyramid_) {
      level[at / 64] |= std::uint64_t{1} << at % 64;
      at /= 64;
    }
  }

  // Removes the most urgent task; the latest pushed on ties.
  TaskId pop() {
    std::size_t at = 0;
    for (std::size_t k = pyramid_.size(); k-- > 0;)
      at = at * 64 + static_cast<std::size_t>(std::countr_zero(pyramid_[k][at]));
    TaskId const task = first_[at];
    first_[at] = next_[task];
    bool is_gone = first_[at] == none;
    for (std::size_t k = 0; k < pyramid_.size() && is_gone; ++k) {
      pyramid_[k][at / 64] &= ~(std::uint64_t{1} << at % 64);
      is_gone = pyramid_[k][at / 64] == 0;
      at /= 64;
    }
    return task;
  }

private:
  static constexpr TaskId none = ~TaskId{0};
  std::vector<TaskId> first_, next_; // per time, per task
  std::vector<std::vector<std::uint64_t>> pyramid_;
};

} // namespace symreal
