// Checkpoint of an explored path: a copy of the process that waits at the kernel's begin. An output that ends as a
// plain number equal to the one it began with may or may not have been written: some paths store 0 over 0. The copy
// then replaces the process, with poison in such outputs, and takes the same path: outputs still poisoned at the end
// were not written. An arm that ends with such outputs does likewise (join.h).
#pragma once

#include "runtime/trace/parts/parts.h"

#include <symreal/real_number.h>

#include <map>
#include <span>

namespace symreal::trace {

// An output that is plain at the end, and the value that it held before.
struct Unwritten {
  RealNumber *number;
  double value;
};

class Checkpoint {
public:
  explicit Checkpoint(Join &join) : join_(join) {}

  // A kernel begins; the copy, if it is asked to go on, returns from here as well, and has a copy in turn.
  void begin();
  // Poisons these in the copy and lets it go on; this process ends as the copy does. Returns if all are poisoned
  // already, or no copy waits.
  void go_back(std::span<Unwritten const> unwritten);
  // Values that the poisoned outputs held before.
  std::map<RealNumber *, double> const &held() const { return held_; }
  // Hands the copy over to another process that goes on for this one.
  void leave_to_others();
  // Ends the copy at the kernel's end.
  void end();

private:
  void wait_as_copy(int source);

  Join &join_;
  int copy_ = 0, to_copy_ = -1;
  std::map<RealNumber *, double> held_;
};

} // namespace symreal::trace
