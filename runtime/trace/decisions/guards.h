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
  // Adds the guards and their locations, the return addresses of the decisions, to the graph.
  void end(Graph &graph);

private:
  struct Recorded {
    NodeId condition;
    std::string text;
    std::vector<std::uintptr_t> stack;
  };
  std::vector<Recorded> recorded_;
  std::set<NodeId> conditions_;
};

} // namespace symreal::trace
