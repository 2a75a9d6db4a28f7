// Progress counters of long work. The work increments them; the console reads them from time to time. Counting costs
// next to nothing and needs no reader.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>

namespace symreal {

// Work that lasts as long as this object. Counters may nest.
class Progress {
public:
  // `unit`: a literal such as "samples". `all`: the total number of units; 0 if unknown.
  explicit Progress(char const *unit, std::size_t all = 0);
  ~Progress();
  Progress(Progress const &) = delete;
  Progress &operator=(Progress const &) = delete;

  // Thread-safe.
  void add(std::size_t count = 1) { done_ += count; }

  // Progress of all current work, the outermost first: "2 of 12 passes, 31 of 100 percent of the search".
  static std::string now();

private:
  std::string text() const;

  char const *const unit_;
  std::size_t const all_;
  std::atomic<std::size_t> done_ = 0;
  Progress *outer_;
};

} // namespace symreal
