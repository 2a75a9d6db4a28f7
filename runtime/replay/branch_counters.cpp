#include "runtime/replay/branch_counters.h"

#include <algorithm>
#include <cstdlib>
#include <sys/mman.h>

// Symbols of clang's profile library; null in a program without it.
extern "C" {
[[gnu::weak]] char *profile_begin_counters() __asm__("__llvm_profile_begin_counters");
[[gnu::weak]] char *profile_end_counters() __asm__("__llvm_profile_end_counters");
[[gnu::weak]] int profile_write_file() __asm__("__llvm_profile_write_file");
}

namespace symreal::replay {

BranchCounters::BranchCounters() {
  if (!profile_begin_counters || !profile_end_counters || !profile_write_file) return;
  counters_ = reinterpret_cast<std::uint64_t *>(profile_begin_counters());
  count_ = static_cast<std::size_t>(reinterpret_cast<std::uint64_t *>(profile_end_counters()) - counters_);
  if (count_ == 0) return;
  void *shared = mmap(nullptr, count_ * sizeof *sums_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, /*fd=*/-1,
                      /*offset=*/0);
  if (shared == MAP_FAILED) std::abort();
  sums_ = static_cast<std::uint64_t *>(shared);
  std::fill_n(counters_, count_, 0);
}

void BranchCounters::add() const {
  for (std::size_t k = 0; k < count_; ++k) sums_[k] += counters_[k];
}

void BranchCounters::write() const {
  if (count_ == 0) return;
  std::copy_n(sums_, count_, counters_);
  if (profile_write_file() != 0) std::abort();
}

} // namespace symreal::replay
