// The conditions on which the recorded path of a kernel rests.
#pragma once

#include "engine/graph/graph.h"

#include <symreal/real_number.h>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symreal::trace {

class Guards {
public:
  static Guards &current(); // one per thread

  void begin();
  // Why nothing else than the outcome is recorded.
  enum class Reason : char { policy, zero, range }; // zero_test.h, range_test.h

  // The program goes on as if the condition had this outcome, which the carried value says too, on the current path.
  // The same condition again adds nothing.
  void add(SymbolicBool condition, bool outcome, Reason reason = Reason::policy);
  // The same in these words, for a condition that holds.
  void add(SymbolicBool condition, std::string text);
  bool empty() const { return recorded_.empty(); }
  struct Recorded {
    NodeId needed; // of the inputs that take one of these arms (join.h), or of all
    std::set<NodeId> arms;
    std::string text; // of what is needed
    Reason reason;
    std::vector<std::uintptr_t> stack = {};
  };
  // In the order in which they came; what is needed on several arms may stand there several times.
  std::vector<Recorded> const &recorded() const { return recorded_; }
  // From the first on: how many conditions are needed for this reason.
  std::size_t count(std::size_t first, Reason reason) const;
  // From the first on, as another process has them.
  void replace(std::size_t first, std::vector<Recorded> guards);
  // Adds the guards, one for each condition, and their locations, the return addresses of the decisions, to the graph.
  void end(Graph &graph);

private:
  void add(SymbolicBool condition, std::string text, Reason reason);
  void add(Recorded guard);

  std::vector<Recorded> recorded_;
  std::set<std::pair<NodeId, std::set<NodeId>>> known_; // of these
};

// A guard as it is where nodes have other numbers.
template <class Here> Guards::Recorded renumbered(Guards::Recorded guard, Here const &here) {
  guard.needed = here(guard.needed);
  std::set<NodeId> arms;
  for (NodeId arm : guard.arms) arms.insert(here(arm));
  guard.arms = std::move(arms);
  return guard;
}

} // namespace symreal::trace
