// Where a kernel begins, on an explored path, a copy of the process waits. Whether an output that is no node at the end
// was written cannot be told if it holds the plain number that it held before: on some paths 0 is written where 0 was.
// Then the copy goes on in the place of the process, with nonsense in such outputs, and comes the same way. What still
// is nonsense at the end was not written. So it is where an arm comes to the end with such outputs (join.h).
#pragma once

#include <symreal/real_number.h>

#include <map>
#include <span>

namespace symreal::trace {

// An output that is no node, and the value that it held before.
struct Unwritten {
  RealNumber *number;
  double value;
};

class Checkpoint {
public:
  static Checkpoint &current(); // one per thread

  // A kernel begins; the copy, if it is asked to go on, returns from here as well, and has a copy in turn.
  void begin();
  // The copy goes on with nonsense in these; this process ends as the copy does. Returns if all have it, or no copy
  // waits.
  void go_back(std::span<Unwritten const> unwritten);
  // What these held before there was nonsense in them.
  std::map<RealNumber *, double> const &held() const { return held_; }
  // Another process goes on for this one, with the copy.
  void leave_to_others();
  // The kernel ends: no copy is needed any more.
  void end();

private:
  void wait_as_copy(int source);

  int copy_ = 0, to_copy_ = -1;
  std::map<RealNumber *, double> held_;
};

} // namespace symreal::trace
