// Timetables without communication, made shorter step by step.
#pragma once

#include "engine/analysis/scheduling/insertion_scheduler.h"
#include "engine/analysis/scheduling/list_scheduler.h"
#include "engine/analysis/scheduling/random.h"
#include "engine/analysis/scheduling/windows.h"

namespace symreal {

// A search for short timetables that keeps the best one. Every method stops once the length is `enough`.
class Improvement {
public:
  Improvement(Network const &network, Units const &units, Time enough);

  // List scheduling from both ends, with the longest tail first, and insertion; each result is justified.
  void try_lists(Windows const &windows);
  // List scheduling with the longest path first, and nothing else: for very many tasks.
  void try_one_list();
  // Local search: the order of the best timetable, disturbed a little or much, is scheduled again and justified
  // (K. Li and R. Willis, 1992; V. Valls, F. Ballestin, S. Quintanilla, 2005). `steps`: of how many timetables.
  void search(Windows const &windows, std::size_t steps, std::uint64_t seed);

  Time length() const { return length_; }
  std::vector<Time> const &start() const { return start_; }
  bool is_enough() const { return length_ <= enough_; }

private:
  // Shifts all tasks to the latest time, the last first, and then to the earliest, the first first, until this shortens
  // nothing. Leaves the result in `start`.
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
