// Ancestor sets of tasks as bit rows. Quadratic in the number of tasks, hence the limit.
#pragma once

#include "engine/analysis/scheduling/network.h"

#include <bit>

namespace symreal {

inline constexpr std::size_t most_tasks_with_ancestors = 8192; // 8 MiB

class Ancestors {
public:
  explicit Ancestors(Network const &network) : words_((network.size() + 63) / 64), bits_(words_ * network.size()) {
    for_each_in_order(network, [&](TaskId task) {
      for (TaskId before : network.before.of(task)) {
        for (std::size_t i = 0; i < words_; ++i) bits_[task * words_ + i] |= bits_[before * words_ + i];
        bits_[task * words_ + before / 64] |= std::uint64_t{1} << before % 64;
      }
    });
  }

  bool has(TaskId task, TaskId other) const { return bits_[task * words_ + other / 64] >> other % 64 & 1; }
  std::size_t count(TaskId task) const {
    std::size_t result = 0;
    for (std::size_t i = 0; i < words_; ++i)
      result += static_cast<std::size_t>(std::popcount(bits_[task * words_ + i]));
    return result;
  }

private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

} // namespace symreal
