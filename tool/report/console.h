// How a run talks to a person: progress, diagnostics and the program's output on standard error.
//
// The counts of a stage (support/progress.h) and its time stand on a terminal in a line that is written
// again and again; elsewhere in a line of its own now and then.
#pragma once

#include "program/record/front.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace symreal::tool {

class Console {
public:
  Console();
  ~Console();
  Console(Console const &) = delete;
  Console &operator=(Console const &) = delete;

  // Bound to this console, which must outlive it.
  program::Talk talk();

  // A stage begins, and the one before ends.
  void stage(std::string_view name);
  void report(Diagnostic const &diagnostic);
  // A line to the user that is no diagnostic.
  void note(std::string const &text);
  // The stage ends: what it comes to is printed next.
  void clear();

private:
  using Clock = std::chrono::steady_clock;

  void watch();
  void show();
  void wipe();
  void print_line(std::string const &line);

  bool is_terminal_;
  bool line_shown_ = false;
  std::chrono::duration<double> interval_; // between lines; 0: none
  std::mutex mutex_;                       // of all that follows, and of standard error
  std::condition_variable changed_;
  std::string stage_; // empty: none
  Clock::time_point begun_, next_;
  bool is_over_ = false;
  std::thread watcher_;
};

} // namespace symreal::tool
