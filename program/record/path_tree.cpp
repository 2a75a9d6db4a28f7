#include "program/record/path_tree.h"

#include "engine/graph/graph.h"
#include "engine/support/number.h"

#include <algorithm>
#include <functional>
#include <set>

namespace symreal::program {
namespace {

bool is_same(Table const &a, Table const &b) {
  return a.name == b.name && a.extents == b.extents && all_same_bits(a.values, b.values);
}

bool is_same(External const &a, External const &b) {
  return a.name == b.name && a.pure == b.pure && a.returned == b.returned && a.parameters == b.parameters &&
         a.derivatives == b.derivatives;
}

bool is_same(Frozen const &a, Frozen const &b) {
  return a.name == b.name && to_string(a.place) == to_string(b.place) && all_same_bits(a.values, b.values);
}

// Adds missing elements to `all`. Returns the index of each element of `more`.
template <class T> std::vector<double> unite(std::vector<T> &all, std::vector<T> const &more) {
  std::vector<double> now;
  for (T const &one : more) {
    auto const known = std::find_if(all.begin(), all.end(), [&](T const &other) { return is_same(other, one); });
    now.push_back(static_cast<double>(known - all.begin()));
    if (known == all.end()) all.push_back(one);
  }
  return now;
}

} // namespace

PathTree::PathTree() = default;

bool PathTree::add(RecordedPath path) {
  if (tree_.empty()) {
    merged_ = without_nodes(path.graph);
    merged_.locations.clear();
    merged_.guards.clear();
    merged_.frozen.clear();
    merged_.tables.clear();
    merged_.externals.clear();
    tree_.emplace_back();
  }
  std::vector<NodeId> const now = take_nodes(path.graph);
  std::size_t at = 0;
  for (DecidedStep const &step : path.steps) {
    NodeId const condition = now[step.condition];
    if (tree_[at].condition == no_node) {
      tree_[at].condition = condition;
      tree_[at].location = location(step.addresses);
      tree_[at].text = step.text;
      tree_[at].is_assumed = step.is_assumed;
      tree_[at].is_joined = step.is_joined;
      tree_[at].is_by_range = step.is_by_range;
    } else if (tree_[at].condition != condition || tree_[at].is_joined != step.is_joined) {
      return false;
    }
    for (bool const outcome : {false, true}) tree_[at].is_met[outcome] |= step.is_met[outcome];
    std::size_t &branch = tree_[at].branches[step.outcome || step.is_joined];
    if (branch == none) {
      branch = tree_.size();
      Node below;
      below.parent = at;
      below.branch_of_parent = step.outcome || step.is_joined;
      at = branch;
      tree_.push_back(std::move(below));
    } else {
      at = branch;
    }
  }
  if (tree_[at].condition != no_node || !tree_[at].results.empty()) return false; // the path ends where others decide
  if (!path.is_cut_off) take_whole(path.graph, now, tree_[at]);
  return true;
}

std::vector<NodeId> PathTree::take_nodes(Graph const &graph) {
  std::vector<double> const tables = unite(merged_.tables, graph.tables);
  std::vector<double> const externals = unite(merged_.externals, graph.externals);
  std::vector<LocationId> at;
  for (Location const &one : graph.locations) at.push_back(location(one.addresses));
  std::vector<NodeId> now;
  now.reserve(graph.nodes.size());
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    NodeId const merged = table_.intern(taken(graph, graph.nodes[id], now, tables, externals));
    now.push_back(merged);
    if (merged == node_location_.size()) { // the node is new
      bool const is_placed = !graph.node_location.empty() && graph.node_location[id] != no_location;
      node_location_.push_back(is_placed ? at[graph.node_location[id]] : no_location);
      node_exact_.push_back(0);
    }
    if (!graph.node_exact.empty() && graph.node_exact[id]) node_exact_[merged] = 1;
  }
  return now;
}

// The node with operands of the merged graph. Tables and functions are constants with their numbers.
symreal::Node PathTree::taken(Graph const &graph, symreal::Node const &node, std::vector<NodeId> const &now,
                              std::vector<double> const &tables, std::vector<double> const &externals) {
  if (is_leaf(node.op)) return node;
  symreal::Node merged = node;
  for (NodeId &operand : merged.operand)
    if (operand != no_node) operand = now[operand];
  auto const renumber = [&](std::size_t which, std::vector<double> const &numbers) {
    auto const number = static_cast<std::size_t>(graph.nodes[node.operand[which]].value());
    merged.operand[which] = table_.constant(numbers[number]);
    node_location_.resize(table_.size(), no_location);
    node_exact_.resize(table_.size(), 0);
  };
  if (node.op == Op::lookup || node.op == Op::lookup2) renumber(0, tables);
  if (node.op == Op::call) renumber(1, externals);
  return merged;
}

LocationId PathTree::location(std::vector<std::uint64_t> const &addresses) {
  auto const [found, is_new] = locations_.try_emplace(addresses, static_cast<LocationId>(merged_.locations.size()));
  if (is_new) merged_.locations.push_back({{}, addresses});
  return found->second;
}

void PathTree::take_whole(Graph &graph, std::vector<NodeId> const &now, Node &end) {
  end.is_open = false;
  for (NodeId result : graph.results) end.results.push_back(now[result]);
  for (Guard &guard : graph.guards) {
    std::vector<std::uint64_t> const &addresses = graph.locations[guard.location].addresses;
    end.guards.push_back({now[guard.condition], location(addresses), std::move(guard.text)});
  }
  (void)unite(merged_.frozen, graph.frozen);
}

std::optional<Outcomes> PathTree::next() const {
  // The newest decision with an untaken branch is the deepest of the newest path.
  for (std::size_t at = tree_.size(); at-- > 0;) {
    Node const &node = tree_[at];
    if (node.condition == no_node || node.is_assumed || node.is_joined) continue;
    auto const is_wanted = [&node](bool outcome) { return node.branches[outcome] == none && node.is_met[outcome]; };
    if (!is_wanted(true) && !is_wanted(false)) continue;
    Outcomes outcomes = is_wanted(true) ? "t" : "f";
    for (std::size_t k = at; tree_[k].parent != none; k = tree_[k].parent) {
      Node const &above = tree_[tree_[k].parent];
      if (!above.is_assumed) outcomes += above.is_joined ? 'j' : tree_[k].branch_of_parent ? 't' : 'f';
    }
    std::reverse(outcomes.begin(), outcomes.end());
    return outcomes;
  }
  return std::nullopt;
}

std::vector<std::vector<std::uint64_t>> PathTree::decided_at() const {
  std::set<LocationId> locations;
  for (Node const &node : tree_)
    if (node.condition != no_node && !node.is_assumed && !node.is_joined) locations.insert(node.location);
  std::vector<std::vector<std::uint64_t>> at;
  for (auto const &[addresses, location] : locations_)
    if (locations.contains(location)) at.push_back(addresses);
  return at;
}

NodeId PathTree::record(Op op, NodeId a, NodeId b, NodeId c, LocationId location) {
  NodeId const id = table_.intern(table_.operation(op, a, b, c));
  if (id == node_location_.size()) {
    node_location_.push_back(location);
    node_exact_.push_back(0);
  }
  return id;
}

NodeId PathTree::negated(NodeId condition) {
  return table_[condition].op == Op::logical_not ? table_[condition].operand[0] : record(Op::logical_not, condition);
}

// Does no path that reaches the kernel's end take this branch?
bool PathTree::is_open(Node const &decision, bool outcome) const {
  return decision.branches[outcome] == none || tree_[decision.branches[outcome]].is_open;
}

// Joins the results of a decision's branches.
void PathTree::join(std::size_t at) {
  Node &node = tree_[at];
  if (node.is_joined) {
    Node &below = tree_[node.branches[1]];
    node.is_open = below.is_open;
    node.results = std::move(below.results);
    return;
  }
  node.is_open = is_open(node, true) && is_open(node, false);
  if (node.is_open) return;
  for (bool outcome : {false, true}) {
    if (!is_open(node, outcome)) continue;
    node.results = std::move(tree_[node.branches[!outcome]].results);
    ++(node.is_by_range ? by_range_ : node.is_assumed ? assumed_ : !node.is_met[outcome] ? unmet_ : open_branches_);
    Guard guard{outcome ? negated(node.condition) : node.condition, node.location,
                node.text + std::string(outcome ? guard_is_false : "")};
    need(std::move(guard), at);
    return;
  }
  std::vector<NodeId> const yes = std::move(tree_[node.branches[true]].results);
  std::vector<NodeId> const no = std::move(tree_[node.branches[false]].results);
  for (std::size_t slot = 0; slot < yes.size(); ++slot) {
    std::size_t const before = table_.size();
    node.results.push_back(
        yes[slot] == no[slot] ? yes[slot] : record(Op::select, node.condition, yes[slot], no[slot], node.location));
    selects_ += table_.size() - before;
  }
}

// Guards of the tree: one for each condition, however many paths need it.

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

Graph PathTree::merge() {
  // Visits branches before their decision.
  for (std::size_t at = tree_.size(); at-- > 0;) {
    if (tree_[at].condition != no_node) join(at);
    for (Guard &guard : tree_[at].guards) need(std::move(guard), at);
  }
  add_guards();
  merged_.results = std::move(tree_.front().results);
  merged_.nodes = table_.release();
  merged_.node_location.resize(node_location_.size());
  std::copy(node_location_.begin(), node_location_.end(), merged_.node_location.begin());
  bool const some_exact = std::find(node_exact_.begin(), node_exact_.end(), 1) != node_exact_.end();
  merged_.node_exact = some_exact ? std::move(node_exact_) : std::vector<char>();
  return std::move(merged_);
}

} // namespace symreal::program
