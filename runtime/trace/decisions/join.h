// Joins: where both ways from a decision come back to one place, with memory that differs in numbers only, they go on
// as one, and a select stands for each number that differs. So n independent branches cost 2n pieces of a run, not 2^n,
// whatever the arms do.
//
// The processes: the program stops at the decision. A coordinator has each way executed by a process of its own
// (arms.h), up to the next decision, and so on from there, until all ways have come together in one process, which goes
// on as the program. If they do not, the program goes on as if nobody had tried, and the decision is one between paths.
#pragma once

#include "runtime/trace/decisions/checkpoint.h"
#include "runtime/trace/decisions/region.h"

#include <unistd.h>

namespace symreal::trace {

// What an explored path does at a decision, as an arm and afterwards.
class Traveller {
public:
  virtual ~Traveller() = default;
  // Of a condition that has only this outcome here.
  virtual std::optional<bool> settled(RealNumber condition) const = 0;
  // An arm goes on for several: what it knows of its own way does not hold for the others.
  virtual void forget(bool is_hypothetical) = 0;
  virtual bool is_hypothetical() const = 0;
};

class Join {
public:
  static Join &current(); // one per thread

  // Whether this process executes an arm.
  bool is_arm() const { return is_arm_; }
  // The program stands at a decision, and its ways may come together. Returns nothing if they do not; else another
  // process goes on in the place of this one. An arm returns the outcome to take.
  // Nothing as well where that would take more pieces of a run than these.
  std::optional<bool> attempt(Stand &stand, Traveller &traveller, std::size_t most_pieces);
  // An arm stands at a decision. Returns the outcome to take, in a process for each; or nothing: all ways have come
  // together here, and this process is the program.
  std::optional<bool> stand(Stand &stand, Traveller &traveller);
  // An arm has come to the end of the kernel with these results. Returns if all have: this process is the program.
  void stand_at_end(std::vector<RealNumber> &results, std::size_t interface, Traveller &traveller);
  // What a process that does this, and ends, would say.
  template <class Action> static bool would(Action action) {
    pid_t const process = fork();
    if (process == 0) _exit(action() ? 1 : 0);
    return exit_status(process) != 0;
  }
  // The last attempt that succeeded.
  JoinCosts const &costs() const;
  // Pieces of a run that the last attempt took, whatever came of it.
  std::size_t tried() const { return shared_ ? shared_->tried : 0; }
  // An arm ends here: it comes to no decision.
  [[noreturn]] void leave();
  // An arm ends here, since nobody can tell whether it has written these. The program goes back to where one can.
  [[noreturn]] void leave_unwritten(std::span<Unwritten const> unwritten);
  // Another process goes on for this one (checkpoint.h).
  void hand_over(pid_t process);

private:
  static constexpr std::size_t most_unwritten = 4096; // or the ways do not come together

  static int exit_status(pid_t process); // -1: it did not end by itself
  struct Shared {
    pid_t main; // the process that is the program
    JoinCosts costs;
    std::size_t tried;
    pid_t arms[Arms::most];
    std::size_t unwritten_count; // of the last arm that has left because of them
    Unwritten unwritten[most_unwritten];
  };

  std::optional<bool> coordinate(Stand &stand, Traveller &traveller, std::size_t most_pieces, int arms);
  [[noreturn]] void stand_for_main();
  void arrive(std::optional<Arrival> const &arrival);
  std::optional<bool> serve(Stand *stand, std::vector<RealNumber> *results, Traveller &traveller);
  void merge(Arms::Merge const &merge, std::vector<RealNumber> *results, Traveller &traveller);

  bool is_arm_ = false, is_root_ = false;
  void hide_output();
  void show_output();

  int shown_[2] = {-1, -1};
  int arm_ = 0, arrived_ = -1; // tells who made this arm that it stands
  Shared *shared_ = nullptr;
  Arms arms_;
  PartingPoint parted_;
};

} // namespace symreal::trace
