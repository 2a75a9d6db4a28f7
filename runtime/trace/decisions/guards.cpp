#include "trace/decisions/guards.h"

#include "graph/guard_words.h"
#include "trace/decisions/policy.h"
#include "trace/describe/describe.h"
#include "trace/nodes/pool.h"
#include "trace/report/call_stack.h"

namespace symreal::trace {

Guards &Guards::current() {
  static constinit thread_local Guards *guards = nullptr;
  if (!guards) guards = new Guards;
  return *guards;
}

void Guards::begin() {
  recorded_.clear();
  conditions_.clear();
}

void Guards::add(SymbolicBool condition, bool outcome) {
  add(outcome ? condition : !condition, describe(condition.condition()) + std::string(outcome ? "" : guard_is_false));
}

void Guards::add(SymbolicBool condition, std::string text) {
  RealNumber const path = current_path();
  SymbolicBool const guard = (!SymbolicBool::from_condition(path)) | condition;
  if (!guard.is_symbolic()) return; // nothing to check: it holds on every run
  if (path.is_node()) text += std::string(guard_where) + describe(path);
  NodeId id = Pool::current().node(guard.condition());
  if (conditions_.insert(id).second) recorded_.push_back({id, std::move(text), call_stack()});
}

void Guards::end(Graph &graph) {
  for (Recorded &guard : recorded_) {
    auto location = static_cast<LocationId>(graph.locations.size());
    graph.locations.push_back({{}, {guard.stack.begin(), guard.stack.end()}});
    graph.guards.push_back({guard.condition, location, std::move(guard.text)});
  }
}

} // namespace symreal::trace
