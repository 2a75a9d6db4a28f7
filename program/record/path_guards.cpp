// Guards of a path tree: one for each condition, however many paths need it.
#include "engine/graph/guard_words.h"
#include "program/record/path_tree.h"

#include <algorithm>
#include <functional>

namespace symreal::program {

void PathTree::need(Guard guard, std::size_t at) {
  Needed &needed = needed_[guard.condition];
  if (needed.at.empty()) needed.guard = std::move(guard);
  needed.at.push_back(at);
}

void PathTree::add_guards() {
  std::vector<Needed> all;
  for (auto &[condition, needed] : needed_) {
    std::ranges::sort(needed.at);
    all.push_back(std::move(needed));
  }
  std::ranges::stable_sort(all, {}, [](Needed const &one) { return one.at.front(); }); // in program order
  for (Needed &one : all) {
    NodeId const asked = asked_at_root(one);
    if (asked != one.guard.condition)
      one.guard.text +=
          std::string(guard_where) + (one.at.size() == 1 ? where(one.at.front()) : std::string(guard_of_several));
    one.guard.condition = asked;
    merged_.guards.push_back(std::move(one.guard));
  }
}

// Conditions under which the program reaches this node of the tree, except those that are guards themselves.
std::string PathTree::where(std::size_t at) const {
  constexpr std::size_t most = 4; // conditions shown
  std::vector<std::string> words;
  std::size_t count = 0;
  for (; tree_[at].parent != none; at = tree_[at].parent) {
    Node const &decision = tree_[tree_[at].parent];
    if (decision.is_joined) continue;
    bool const outcome = tree_[at].branch_of_parent;
    if (!is_open(decision, !outcome) && count++ < most)
      words.push_back(decision.text + std::string(outcome ? "" : guard_is_false));
  }
  std::string text;
  for (std::size_t k = words.size(); k-- > 0;) text += words[k] + (k ? ", " : "");
  if (count > words.size()) text += " and " + std::to_string(count - words.size()) + " more conditions";
  return text;
}

// Condition at the root: the guard's condition holds, or the program reaches no node of the tree that needs it.
NodeId PathTree::asked_at_root(Needed const &needed) {
  std::map<std::size_t, NodeId, std::greater<>> asked; // by node of the tree; branches before their decision
  for (std::size_t at : needed.at)
    for (std::size_t above = at; above != none; above = tree_[above].parent) asked[above] = no_node;
  for (std::size_t at : needed.at) asked[at] = needed.guard.condition;
  for (auto &[at, here] : asked) {
    if (here != no_node) continue;
    Node const &decision = tree_[at];
    auto const below = [&](bool outcome) {
      auto const found = asked.find(decision.branches[outcome]);
      return found == asked.end() ? no_node : found->second;
    };
    here = decision.is_joined ? below(true) : asked_at(decision, below(true), below(false));
  }
  return asked.rbegin()->second;
}

// Combines the conditions of a decision's branches; equal ones do not depend on the decision. no_node: no condition.
NodeId PathTree::asked_at(Node const &decision, NodeId yes, NodeId no) {
  auto const unless = [&](bool outcome, NodeId asked) { // an open branch has a guard of its own
    if (asked == no_node || is_open(decision, outcome)) return asked;
    return record(Op::logical_or, outcome ? decision.condition : negated(decision.condition), asked);
  };
  if (yes == no) return yes;
  NodeId const on_yes = unless(false, yes), on_no = unless(true, no);
  if (on_yes == no_node || on_no == no_node) return on_yes == no_node ? on_no : on_yes;
  return record(Op::logical_and, on_yes, on_no);
}

} // namespace symreal::program
