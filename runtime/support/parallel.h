// Work in several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace symreal {

// Calls work(k) for each k below count, so many at once. `work` does not throw.
template <class Work> void in_parallel(std::size_t count, unsigned jobs, Work work) {
  std::atomic<std::size_t> next = 0;
  auto const worker = [&] {
    for (std::size_t k = next++; k < count; k = next++) work(k);
  };
  std::vector<std::jthread> helpers;
  for (std::size_t i = 1; i < std::min<std::size_t>(std::max(1U, jobs), count); ++i) helpers.emplace_back(worker);
  worker();
}

} // namespace symreal
