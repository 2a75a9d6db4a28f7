// The conditions on which the recorded path of a kernel rests.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/trace/parts/parts.h"

#include <symreal/real_number.h>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace symreal::trace {

class Guards {
public:
  Guards(Pool &pool, Conditions const &conditions) : pool_(pool), conditions_(conditions) {}

  void begin();
  // Reason why only one outcome is recorded.
  enum class Reason : char { policy, zero, range }; // known_outcomes.h

  // Assumes that the condition has this outcome, the carried value's, on the current path. A repeated condition adds
  // nothing.
  void add(SymbolicBool condition, bool outcome, Reason reason = Reason::policy);
  // Assumes a condition that holds, with this text.
  void add(SymbolicBool condition, std::string text);
  bool empty() const { return recorded_.empty(); }
  struct Recorded {
    NodeId needed; // condition for the inputs that take one of these arms (join.h), or for all
    std::set<NodeId> arms;
    std::string text; // of the condition
    Reason reason;
    std::vector<std::uintptr_t> stack = {};
  };
  // Guards in recording order; one that several arms need may occur several times.
  std::vector<Recorded> const &recorded() const { return recorded_; }
  // Number of conditions with this reason, from index `first` on.
  std::size_t count(std::size_t first, Reason reason) const;
  // Replaces the guards from index `first` on by another process's.
  void replace(std::size_t first, std::vector<Recorded> guards);
  // Adds the guards, one for each condition, and their locations, the return addresses of the decisions, to the graph.
  void end(Graph &graph);

private:
  void add(SymbolicBool condition, std::string text, Reason reason);
  void add(Recorded guard);

  Pool &pool_;
  Conditions const &conditions_;
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
