// Topological order by priority: of the tasks whose predecessors have been visited, the one of greatest priority, then
// of smallest id, comes next. Reuses its memory among runs.
#pragma once

#include "engine/analysis/scheduling/network.h"

#include <algorithm>
#include <utility>

namespace symreal {

class PriorityOrder {
public:
  template <class Visit> void for_each(Network const &network, std::span<Time const> priority, Visit const &visit) {
    waits_for_.resize(network.size());
    for (TaskId task = 0; task < network.size(); ++task) {
      waits_for_[task] = static_cast<std::uint32_t>(network.before.of(task).size());
      if (waits_for_[task] == 0) ready_.push_back({priority[task], ~task});
    }
    std::ranges::make_heap(ready_);
    while (!ready_.empty()) {
      std::ranges::pop_heap(ready_);
      TaskId const task = ~ready_.back().second;
      ready_.pop_back();
      visit(task);
      for (TaskId after : network.after.of(task))
        if (--waits_for_[after] == 0) {
          ready_.push_back({priority[after], ~after});
          std::ranges::push_heap(ready_);
        }
    }
  }

private:
  std::vector<std::uint32_t> waits_for_;
  std::vector<std::pair<Time, TaskId>> ready_; // max-heap of priority and complement of id
};

} // namespace symreal
