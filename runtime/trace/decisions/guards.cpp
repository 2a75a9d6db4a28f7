#include "runtime/trace/decisions/guards.h"

#include "engine/graph/graph.h"
#include "runtime/memory/heap_blocks.h"
#include "runtime/trace/decisions/decisions.h"
#include "runtime/trace/describe/describe.h"
#include "runtime/trace/nodes/pool.h"
#include "runtime/trace/report/call_stack.h"

#include <map>

namespace symreal::trace {

void Guards::begin() {
  recorded_.clear();
  known_.clear();
}

void Guards::add(SymbolicBool condition, bool outcome, Reason reason) {
  memory::OwnWork const own;
  add(outcome ? condition : !condition, describe(condition.condition()) + std::string(outcome ? "" : guard_is_false),
      reason);
}

void Guards::add(SymbolicBool condition, std::string text) {
  memory::OwnWork const own;
  add(condition, std::move(text), Reason::policy);
}

void Guards::add(SymbolicBool condition, std::string text, Reason reason) {
  RealNumber const path = conditions_.path, arm = conditions_.arm;
  SymbolicBool const guard = (!SymbolicBool::from_condition(path)) | condition;
  if (!guard.is_symbolic()) return; // nothing to check: it holds on every run
  if (path.is_node()) text += std::string(guard_where) + describe(path);
  Recorded recorded{pool_.node(guard.condition()), {}, std::move(text), reason};
  if (arm.is_node()) recorded.arms = {pool_.node(arm)};
  if (known_.contains({recorded.needed, recorded.arms})) return;
  recorded.stack = call_stack();
  add(std::move(recorded));
}

void Guards::add(Recorded guard) {
  if (known_.insert({guard.needed, guard.arms}).second) recorded_.push_back(std::move(guard));
}

void Guards::replace(std::size_t first, std::vector<Recorded> guards) {
  recorded_.resize(first);
  known_.clear();
  for (Recorded const &guard : recorded_) known_.insert({guard.needed, guard.arms});
  for (Recorded &guard : guards) add(std::move(guard));
}

std::size_t Guards::count(std::size_t first, Reason reason) const {
  std::set<NodeId> needed;
  for (std::size_t k = first; k < recorded_.size(); ++k)
    if (recorded_[k].reason == reason) needed.insert(recorded_[k].needed);
  return needed.size();
}

void Guards::end(Graph &graph) {
  std::map<NodeId, std::set<NodeId>> arms;
  std::set<NodeId> everywhere;
  for (Recorded const &guard : recorded_) {
    arms[guard.needed].insert(guard.arms.begin(), guard.arms.end());
    if (guard.arms.empty()) everywhere.insert(guard.needed);
  }
  for (Recorded const &guard : recorded_) {
    auto const found = arms.find(guard.needed);
    if (found == arms.end()) continue; // its guard stands there
    NodeId condition = guard.needed;
    std::string text = guard.text;
    if (!everywhere.contains(guard.needed)) {
      SymbolicBool any(false);
      for (NodeId arm : found->second) any = any | SymbolicBool::from_condition(pool_.number(arm));
      condition = pool_.node(((!any) | SymbolicBool::from_condition(pool_.number(guard.needed))).condition());
      text += std::string(guard_where) +
              (found->second.size() == 1 ? describe(any.condition()) : std::string(guard_of_several));
    }
    arms.erase(found);
    auto const location = static_cast<LocationId>(graph.locations.size());
    graph.locations.push_back({{}, {guard.stack.begin(), guard.stack.end()}});
    graph.guards.push_back({condition, location, std::move(text)});
  }
}

} // namespace symreal::trace
