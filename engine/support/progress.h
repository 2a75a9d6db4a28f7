// Progress of long work. The work counts; the console reads the counts from time to time. Counting costs next to
// nothing and does not need a reader.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>

namespace symreal {

// Work that goes on as long as this lives. Inside of it other work may be counted.
class Progress {
public:
  // `unit`: what is counted, a literal such as "samples". `all`: of how many; 0 where that is unknown.
  explicit Progress(char const *unit, std::size_t all = 0);
  ~Progress();
  Progress(Progress const &) = delete;
  Progress &operator=(Progress const &) = delete;

  // From any thread.
  void add(std::size_t count = 1) { done_ += count; }

  // "2 of 12 passes, 31 of 100 percent of the search": of all work that goes on, the outermost first.
  static std::string now();

private:
  std::string text() const;

  char const *const unit_;
  std::size_t const all_;
  std::atomic<std::size_t> done_ = 0;
  Progress *outer_;
};

} // namespace symreal
