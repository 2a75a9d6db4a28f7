// List scheduling: time advances; whenever a unit is free and a task of its kind is ready, the most urgent such task
// begins. A unit idles only if it has no ready task (R. L. Graham, 1966).
#pragma once

#include "engine/analysis/scheduling/network.h"
#include "engine/analysis/scheduling/timetable.h"

#include <queue>

namespace symreal {

class ListScheduler {
public:
  ListScheduler(Network const &network, Units const &units) : network_(network), units_(units) {}

  // Tasks of greater priority, then of smaller id, are more urgent. Returns the length.
  Time run(std::span<Time const> priority, std::vector<Time> &start);

private:
  struct Urgent {
    Time priority;
    TaskId task;
    bool operator<(Urgent const &other) const {
      return priority != other.priority ? priority < other.priority : task > other.task;
    }
  };
  struct End {
    Time at;
    TaskId task;
    auto operator<=>(End const &) const = default;
  };
  void make_ready(TaskId task);
  void end_task(TaskId task);

  Network const &network_;
  Units const &units_;
  std::span<Time const> priority_;
  Time now_ = 0;
  std::vector<Time> *start_ = nullptr;
  std::vector<std::uint32_t> waits_for_;           // per task: predecessors that have not ended
  std::vector<std::priority_queue<Urgent>> ready_; // per kind
  std::vector<TaskId> instant_;                    // ready tasks of zero duration
  std::priority_queue<End, std::vector<End>, std::greater<>> running_;
};

} // namespace symreal
