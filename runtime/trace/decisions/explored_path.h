// One path through the decisions of a kernel, under policy explore. The driver runs the program once for each path, and
// prescribes its first outcomes:
//
//   path=K:outcomes:depth:pieces, as in 0:tft:64:4000, or 0:tft:64z:0
//
// An outcome j: both arms of the decision come together again, and are recorded as one (join.h). Beyond the prescribed
// outcomes the program tries a join first, until failed attempts have taken so many pieces of a run.
//
// The K-th kernel of the run takes these outcomes at its first decisions, and those of its carried values from there
// on; other kernels of the run do so from the beginning. A condition that earlier outcomes settle does not count as a
// decision. Beyond `depth` decisions the path of this run goes on, each outcome a guard; any other path is cut off and
// its recording until then handed over. `outcomes` that end in `!` are cut off at the last one.
//
// A test for exact zero that the carried values do not satisfy is taken as false and has no prescribed outcome; with
// `z` behind the depth it is a decision like any other.
//
// Each decision is reported to the driver by an event `decided`. The file `taken` has a byte for each as well, even if
// the program crashes.
#pragma once

#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/decisions/join.h"
#include "runtime/trace/decisions/known_outcomes.h"

#include <symreal/real_number.h>

#include <cstddef>
#include <string>

namespace symreal::trace {

class ExploredPath : private Traveller {
public:
  ExploredPath(Pool &pool, Kernel &kernel, Conditions &conditions, Guards &guards, Join &join)
      : pool_(pool),
        kernel_(kernel),
        conditions_(conditions),
        guards_(guards),
        join_(join) {}

  // Whether a driver runs this program along a path; false in a program started by hand.
  static bool is_asked_for();

  // A kernel begins.
  void begin();
  bool decide(Stand &stand);
  // Whether this kernel's path is one among others.
  bool has_decisions() const { return count_ != 0; }
  // Whether the program takes a path that its carried values do not, so that they say nothing of its behaviour.
  bool is_hypothetical() const override { return is_hypothetical_; }
  // Ends the kernel of an arm, with the arm's own results.
  void end_arm(std::vector<NodeId> &results, std::size_t interface);
  // The kernel ends.
  void end();

private:
  std::optional<bool> settled(RealNumber condition) const override;
  void forget(bool is_hypothetical) override;
  std::optional<bool> known(NodeId condition) const;
  // An outcome assumed without a path for the other one, which a guard rejects.
  struct Assumed {
    bool outcome;
    Guards::Reason reason;
  };
  std::optional<Assumed> assumed(NodeId condition, bool carried) const;
  bool take_in_arm(Stand const &stand, bool outcome);
  void begin_attempt(RealNumber condition);
  void note_in_vain(std::size_t pieces);
  void end_attempt();
  void take(NodeId condition, bool outcome, RealNumber number);
  void tell(NodeId condition, bool outcome, RealNumber number, char const *letter);

  Pool &pool_;
  Kernel &kernel_;
  Conditions &conditions_;
  Guards &guards_;
  Join &join_;
  bool is_explored_ = false, is_hypothetical_ = false, is_cut_at_end_ = false, explores_zeros_ = false;
  std::size_t kernels_ = 0, count_ = 0, followed_ = 0, beyond_ = 0, depth_ = 0, pieces_left_ = 0;
  std::string prescribed_;
  KnownOutcomes known_, known_before_; // before the last attempt at a join
  std::size_t count_before_ = 0, guards_before_ = 0;
  RealNumber attempted_ = 0.0; // the decision where that was, and its place
  std::vector<std::uintptr_t> attempted_at_;
};

} // namespace symreal::trace
