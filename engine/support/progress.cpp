#include "engine/support/progress.h"

#include <fmt/format.h>
#include <mutex>

namespace symreal {

namespace {

constinit std::mutex guard;
constinit Progress *innermost = nullptr;

} // namespace

Progress::Progress(char const *unit, std::size_t all) : unit_(unit), all_(all) {
  std::scoped_lock const lock(guard);
  outer_ = innermost;
  innermost = this;
}

// Unlinks the counter anywhere in the list, since threads may end in any order.
Progress::~Progress() {
  std::scoped_lock const lock(guard);
  Progress **link = &innermost;
  while (*link != this) link = &(*link)->outer_;
  *link = outer_;
}

std::string Progress::text() const {
  std::size_t const done = done_;
  return all_ == 0 ? fmt::format("{} {}", done, unit_) : fmt::format("{} of {} {}", done, all_, unit_);
}

std::string Progress::now() {
  std::scoped_lock const lock(guard);
  std::string all;
  for (Progress const *one = innermost; one; one = one->outer_) all = one->text() + (all.empty() ? "" : ", ") + all;
  return all;
}

} // namespace symreal
