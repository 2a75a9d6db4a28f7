// Generated code and a recorded graph inside the replayed program: see replay_protocol.h.
#pragma once

#include "engine/graph/graph.h"
#include "runtime/replay/replay_protocol.h"

namespace symreal::replay {

class ReplayCode {
public:
  // Loads the code that the environment names, if any. Ends the process if it cannot be loaded.
  ReplayCode();
  void run_generated(Head &head) const;
  // 0, or the number of the guard that does not hold.
  int compute(Head const &head, double const *inputs, double const *parameters, double *outputs) const;
  void run_graph(Head &head) const;
  // Answers calls until the client sends no_function, or has gone.
  void answer_calls(Head &head, int commands, int answers) const;

private:
  void *library_ = nullptr;
  std::string prefix_;
  Graph graph_;
};

} // namespace symreal::replay
