#include "trace/decisions/guards.h"

#include "graph/guard_words.h"
#include "memory/heap_blocks.h"
#include "trace/decisions/policy.h"
#include "trace/describe/describe.h"
#include "trace/nodes/pool.h"
#include "trace/report/call_stack.h"

namespace symreal::trace {

Guards &Guards::current() {
  static constinit thread_local Guards *guards = nullptr;
  if (!guards) guards = memory::make_own<Guards>();
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
  Recorded recorded = on_arm({no_node, Pool::current().node(guard.condition()), std::move(text), {}}, current_arm());
  if (!conditions_.insert(recorded.condition).second) return;
  recorded.stack = call_stack();
  recorded_.push_back(std::move(recorded));
}

Guards::Recorded Guards::on_arm(Recorded guard, RealNumber arm) {
  Pool &pool = Pool::current();
  SymbolicBool const needed = SymbolicBool::from_condition(pool.number(guard.needed));
  SymbolicBool const asked = (!SymbolicBool::from_condition(arm)) | needed;
  guard.condition = pool.node(asked.condition());
  guard.arm = arm.is_node() ? std::string(guard_where) + describe(arm) : "";
  return guard;
}

void Guards::replace(std::size_t first, std::vector<Recorded> guards) {
  recorded_.resize(first);
  conditions_.clear();
  for (Recorded const &guard : recorded_) conditions_.insert(guard.condition);
  for (Recorded &guard : guards)
    if (conditions_.insert(guard.condition).second) recorded_.push_back(std::move(guard));
}

void Guards::end(Graph &graph) {
  for (Recorded &guard : recorded_) {
    auto location = static_cast<LocationId>(graph.locations.size());
    graph.locations.push_back({{}, {guard.stack.begin(), guard.stack.end()}});
    graph.guards.push_back({guard.condition, location, guard.text + guard.arm});
  }
}

} // namespace symreal::trace
