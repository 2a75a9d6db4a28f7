// Iterative improvement of timetables without communication.
#pragma once

#include "engine/analysis/scheduling/bounds.h"
#include "engine/analysis/scheduling/list_scheduler.h"
#include "engine/analysis/scheduling/random.h"

namespace symreal {

// Search for short timetables that keeps the best one. Each method stops when the length is `enough`.
class Improvement {
public:
  Improvement(Network const &network, Units const &units, Time enough);

  // List scheduling and insertion from both ends, longest tail first; each result is justified.
  void try_lists(Windows const &windows);
  // Plain list scheduling, longest path first, for very many tasks.
  void try_one_list();
  // Local search: disturbs the order of the best timetable, schedules it again and justifies the result (K. Li and R.
  // Willis, 1992; V. Valls, F. Ballestin, S. Quintanilla, 2005). `steps` is the number of timetables.
  void search(Windows const &windows, std::size_t steps, std::uint64_t seed);

  Time length() const { return length_; }
  std::vector<Time> const &start() const { return start_; }
  bool is_enough() const { return length_ <= enough_; }

private:
  // Justification: shifts all tasks to the latest time, last first, then to the earliest, first first, until the length
  // stops falling. The result replaces `start`.
  Time justify(std::vector<Time> &start, Time length);
  void keep(std::vector<Time> const &start, Time length);
  Time disturbed(std::vector<Time> const &base, bool forward, Random &random, std::vector<Time> &start);

  Network const &network_;
  Time enough_;
  Network const reversed_;
  ListScheduler list_, list_from_end_;
  InsertionScheduler insertion_, insertion_from_end_;
  Time length_ = 0;
  std::vector<Time> start_, priority_, other_;
};

} // namespace symreal
