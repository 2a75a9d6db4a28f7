// Joins: if both arms of a decision come back to one place, with memory that differs in numbers only, they go on as
// one, and a select stands for each number that differs. So n independent branches cost 2n pieces of a run, not 2^n,
// whatever the arms do.
//
// The processes: the program stops at the decision. A coordinator has each arm executed by a process of its own
// (arms.h), up to the next decision, and so on from there, until all arms have come together in one process, which goes
// on as the program. If they do not, the program goes on as before the attempt, and the decision is one between paths.
#pragma once

#include "runtime/trace/decisions/checkpoint.h"
#include "runtime/trace/decisions/region.h"

#include <unistd.h>

namespace symreal::trace {

// Interface to an explored path, for its decisions as an arm and afterwards.
class Traveller {
public:
  virtual ~Traveller() = default;
  // The outcome of a condition that can have only one here; nullopt if both are possible.
  virtual std::optional<bool> settled(RealNumber condition) const = 0;
  // Drops knowledge of the arm's own path: it goes on for several.
  virtual void forget(bool is_hypothetical) = 0;
  virtual bool is_hypothetical() const = 0;
};

class Join {
public:
  Join(Pool &pool, State &state, Conditions &conditions, Guards &guards, Checkpoint &checkpoint)
      : pool_(pool),
        state_(state),
        conditions_(conditions),
        guards_(guards),
        checkpoint_(checkpoint) {}

  // Whether this process executes an arm.
  bool is_arm() const { return is_arm_; }
  // Tries to join the arms of the decision at which the program stands. Nullopt if they do not come together or would
  // take more pieces of a run than `most_pieces`; on success another process goes on in the place of this one. An arm
  // returns the outcome to take.
  std::optional<bool> attempt(Stand &stand, Traveller &traveller, std::size_t most_pieces);
  // An arm stands at a decision. Returns the outcome to take, in a process for each; nullopt if all arms have come
  // together here, and this process is the program.
  std::optional<bool> stand(Stand &stand, Traveller &traveller);
  // An arm has come to the end of the kernel with these results. Returns if all have: this process is the program.
  void stand_at_end(std::vector<RealNumber> &results, std::size_t interface, Traveller &traveller);
  // Result of the action, executed in a fork so that its effects are discarded.
  template <class Action> static bool would(Action action) {
    pid_t const process = fork();
    if (process == 0) _exit(action() ? 1 : 0);
    return exit_status(process) != 0;
  }
  // Costs of the last attempt that succeeded.
  JoinCosts const &costs() const;
  // Pieces of a run that the last attempt took, successful or not.
  std::size_t tried() const { return shared_ ? shared_->tried : 0; }
  // Ends an arm that comes to no decision.
  [[noreturn]] void leave();
  // Ends an arm that may not have written these. The program goes back to its checkpoint, where this can be decided.
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
    std::size_t unwritten_count; // of the last arm that ended because of them
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

  Pool &pool_;
  State &state_;
  Conditions &conditions_;
  Guards &guards_;
  Checkpoint &checkpoint_;
  int shown_[2] = {-1, -1};
  int arm_ = 0, arrived_ = -1; // whether its parent was notified that it stands
  Shared *shared_ = nullptr;
  Arms arms_;
  PartingPoint parted_;
};

} // namespace symreal::trace
