// What it costs that threads work together on a machine, and how that is measured: a C program, and the reading of what
// it prints. All in nanoseconds.
//
// Method: threads that spin on an atomic, each bound to a processor, those of different cores first. A hand-over is
// half the way of a number to another thread and back. A barrier is that of all threads. A wake-up hands a job to a
// thread that sleeps, and waits for its end; a start makes a thread for the job. A region has sections with nothing to
// do, one for each of its threads, which OpenMP lets spin between two calls. Medians over rounds; where other processes
// take the processors away they are far larger, so that a machine with nothing else to do should be measured.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct ThreadCosts {
  unsigned processors = 1, cores = 1; // that a process may use
  // The rest is measured where there are two processors at least.
  double hand_over = 0, wake = 0, start = 0;
  struct Barrier {
    unsigned threads;
    double nanoseconds;
  };
  std::vector<Barrier> barriers = {}; // for 2, 4, ... threads
  std::vector<Barrier> sections = {}; // the same of a region of OpenMP sections, where the compiler has it

  bool is_measured() const { return !barriers.empty(); }
  // That of so many threads, or of the next number that was measured.
  double barrier(unsigned threads) const;
  double sections_for(unsigned threads) const;
};

// C11 with POSIX threads. Takes the number of rounds as its argument.
std::string_view thread_measuring_program();
inline constexpr std::string_view thread_measuring_flags = "-O1 -std=gnu11 -pthread";

// C with OpenMP; of the same argument, and for this machine's number of processors.
std::string sections_measuring_program();
inline constexpr std::string_view sections_measuring_flags = "-O1 -std=gnu11 -fopenmp";
// From its output; none if the output is not that of the program.
std::vector<ThreadCosts::Barrier> measured_sections(std::string_view output);

// From its output; nothing if the output is not that of the program.
std::optional<ThreadCosts> measured_thread_costs(std::string_view output);

// The member "threads" of a file of costs. Throws what nlohmann::json throws, std::out_of_range.
nlohmann::ordered_json to_json(ThreadCosts const &costs);
ThreadCosts thread_costs(nlohmann::json const &json);

} // namespace symreal
