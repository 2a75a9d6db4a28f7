// The conditions on which the recorded path of a kernel rests.
#pragma once

#include "graph/graph.h"

#include <symreal/real_number.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace symreal::trace {

class Guards {
public:
  static Guards &current(); // one per thread

  void begin();
  // The program goes on as if the condition had this outcome, which the carried value says too, on the current path.
  // The same condition again adds nothing.
  void add(SymbolicBool condition, bool outcome);
  // The same in these words, for a condition that holds.
  void add(SymbolicBool condition, std::string text);
  bool empty() const { return recorded_.empty(); }
  struct Recorded {
    NodeId condition; // asked of every input
    NodeId needed;    // ... of those that take this arm (join.h)
    std::string text; // of what is needed
    std::vector<std::uintptr_t> stack;
    std::string arm = {}; // in words
  };
  // Needed where this condition holds.
  static Recorded on_arm(Recorded guard, RealNumber arm);
  std::vector<Recorded> const &recorded() const { return recorded_; }
  // From the first on, as another process has them.
  void replace(std::size_t first, std::vector<Recorded> guards);
  // Adds the guards and their locations, the return addresses of the decisions, to the graph.
  void end(Graph &graph);

private:
  std::vector<Recorded> recorded_;
  std::set<NodeId> conditions_;
};

} // namespace symreal::trace
