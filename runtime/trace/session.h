// The session of a thread: the parts of the recorder, and the order in which a kernel starts and stops them.
//
// One session per thread rather than one behind a mutex: kernels recorded by several threads do not meet. It is made
// when the thread first asks, and never destroyed: numbers with static storage would outlive it otherwise.
#pragma once

#include "runtime/trace/annotations.h"
#include "runtime/trace/calls/external_call.h"
#include "runtime/trace/decisions/checkpoint.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/decisions/explored_path.h"
#include "runtime/trace/decisions/guards.h"
#include "runtime/trace/decisions/join.h"
#include "runtime/trace/kernel/kernel.h"
#include "runtime/trace/nodes/externals.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/nodes/torn_numbers.h"
#include "runtime/trace/parts/parts.h"
#include "runtime/trace/state/state.h"
#include "runtime/trace/text/environment.h"
#include "runtime/trace/text/text_marks.h"
#include "runtime/trace/text/type_names.h"

#include <span>

namespace symreal::trace {

class Session final : public Parts {
public:
  Session();
  static Session &of_this_thread() { return static_cast<Session &>(session()); }

  // Starts all parts. `frame`: of the function in which the kernel begins. A copy of the process that is asked to go on
  // (checkpoint.h) returns from here as well.
  void begin_kernel(std::string const &name, void const *frame);
  // The kernel has run: stops what its own statements must not notice, and judges that. If the copy of the process has
  // to find out which of these were written, this process ends as the copy does.
  void leave_kernel(std::string const &name, Place const &place, std::span<Unwritten const> unwritten);
  // Stops all parts and moves what they have recorded to the graph. `has_notes`: the program notes its reads and
  // writes. `written`: numbers that hold nodes, and become plain.
  void end_kernel(Graph &graph, Place const &place, bool has_notes, std::span<RealNumber *const> written);
  // Gives a kernel up in its middle: the graph gets what is recorded so far.
  void cut_off_kernel(Graph &graph);
  // Whether the kernel leaves more behind than its results. The parts stop in a fork, and go on here.
  bool leaves_more(Place const &place, bool has_notes);

  Annotations annotations;

private:
  std::vector<Frozen> judge_memory(Place const &place, bool has_notes);
  void release_nodes(Graph &graph);

  Pool pool_{torn_numbers_};
  TornNumbers torn_numbers_{pool_};
  Externals externals_{pool_};
  ExternalShapes external_shapes_;
  Kernel kernel_;
  State state_;
  Conditions conditions_;
  Guards guards_{pool_, conditions_};
  Checkpoint checkpoint_{join_};
  Join join_{pool_, state_, conditions_, guards_, checkpoint_};
  ExploredPath path_{pool_, kernel_, conditions_, guards_, join_};
  TextMarks text_marks_;
  Environment environment_{pool_};
  TypeNames type_names_;
};

} // namespace symreal::trace
