// Costs of thread cooperation on a machine, in nanoseconds, and their measurement: a C program and the parser of its
// output.
//
// Method: threads bound to processors, those of different cores first, spin on an atomic. A hand-over is half the round
// trip of a number between two threads. A barrier joins all threads. A wake-up hands a job to a sleeping thread and
// waits for its end; a start creates a thread for the job. A region has one empty section per thread, and OpenMP lets
// the threads spin between two calls. Medians over rounds; other processes inflate them, so the machine should be
// otherwise idle.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct ThreadCosts {
  unsigned processors = 1, cores = 1; // available to a process
  // The other costs are measured if there are at least two processors.
  double hand_over = 0, wake = 0, start = 0;
  struct Barrier {
    unsigned threads;
    double nanoseconds;
  };
  std::vector<Barrier> barriers = {}; // for 2, 4, ... threads
  std::vector<Barrier> sections = {}; // likewise for a region of OpenMP sections, if the compiler has OpenMP

  bool is_measured() const { return !barriers.empty(); }
  // Cost for this number of threads, or the next larger measured one.
  double barrier(unsigned threads) const;
  double sections_for(unsigned threads) const;
};

// C11 with POSIX threads. Takes the number of rounds as its argument.
std::string_view thread_measuring_program();
inline constexpr std::string_view thread_measuring_flags = "-O1 -std=gnu11 -pthread";

// C with OpenMP. Takes the same argument; tests up to this machine's number of processors.
std::string sections_measuring_program();
inline constexpr std::string_view sections_measuring_flags = "-O1 -std=gnu11 -fopenmp";
// Parses the program's output; empty if malformed.
std::vector<ThreadCosts::Barrier> measured_sections(std::string_view output);

// Parses the program's output; nullopt if malformed.
std::optional<ThreadCosts> measured_thread_costs(std::string_view output);

// Member "threads" of a cost file. Throws exceptions of nlohmann::json and std::out_of_range.
nlohmann::ordered_json to_json(ThreadCosts const &costs);
ThreadCosts thread_costs(nlohmann::json const &json);

} // namespace symreal
