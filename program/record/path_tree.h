// Merges the recorded paths of one kernel into one graph: equal nodes become one, and each output is a tree of selects
// over the paths' results, without selects between equal values. A missing path leaves the tree open; a guard refuses
// each open branch.
#pragma once

#include "engine/graph/graph.h"
#include "engine/graph/node_table.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

struct DecidedStep {
  NodeId condition; // node in the graph of the path
  bool outcome;
  bool is_assumed;  // the other outcome is not explored
  bool is_joined;   // both branches are recorded and joined
  std::string text; // text of the condition
  std::vector<std::uint64_t> addresses = {};
  bool is_by_range = false;      // assumed, as the other outcome lies outside an input's range
  bool is_met[2] = {true, true}; // by outcome: does some given sample that reaches the step have it?
};

struct RecordedPath {
  Graph graph; // without outputs if the path is cut off
  std::vector<DecidedStep> steps;
  bool is_cut_off = false;
};

using Outcomes = std::string; // one letter per decision: t, f, or j if its branches have joined

class PathTree {
public:
  PathTree();

  // Adds a path. False if it decides on another value than paths of the same beginning: the program does not repeat.
  bool add(RecordedPath path);

  // Beginning of the next path in depth-first order; no path has taken its last outcome. Nullopt if none is left that a
  // sample takes.
  std::optional<Outcomes> next() const;

  // Merges all paths into one graph; consumes the tree.
  Graph merge();

  // After `merge`: number of selects between paths, and of open branches.
  std::size_t selects() const { return selects_; }
  std::size_t open_branches() const { return open_branches_; }
  // Branches that no given sample takes, not counted as open.
  std::size_t unmet() const { return unmet_; }
  // Call stacks of the decisions, without duplicates and assumed ones.
  std::vector<std::vector<std::uint64_t>> decided_at() const;
  // Decisions whose other outcome was assumed away, not counted as open.
  std::size_t assumed() const { return assumed_; }
  std::size_t assumed_by_range() const { return by_range_; }

private:
  static constexpr std::size_t none = ~std::size_t{0};
  // A decision, or the end of a path.
  struct Node {
    std::size_t parent = none;
    bool branch_of_parent = false;
    NodeId condition = no_node; // in the merged graph; no_node: a path ends here
    LocationId location = no_location;
    std::string text = {};
    std::size_t branches[2] = {none, none}; // by outcome
    bool is_assumed = false, is_joined = false, is_by_range = false;
    bool is_met[2] = {false, false};
    bool is_open = true; // no path below reaches the kernel's end
    std::vector<NodeId> results = {};
    std::vector<Guard> guards = {}; // guards of the path that ends here
  };

  std::vector<NodeId> take_nodes(Graph const &graph);
  symreal::Node taken(Graph const &graph, symreal::Node const &node, std::vector<NodeId> const &now,
                      std::vector<double> const &tables, std::vector<double> const &externals);
  LocationId location(std::vector<std::uint64_t> const &addresses);
  void take_whole(Graph &graph, std::vector<NodeId> const &now, Node &end);
  void join(std::size_t at);
  bool is_open(Node const &decision, bool outcome) const;
  NodeId record(Op op, NodeId a, NodeId b = no_node, NodeId c = no_node, LocationId location = no_location);
  NodeId negated(NodeId condition);

  // A guard, and the tree nodes below which it is needed.
  struct Needed {
    Guard guard;
    std::vector<std::size_t> at;
  };
  void need(Guard guard, std::size_t at);
  void add_guards();
  std::string where(std::size_t at) const;
  NodeId asked_at_root(Needed const &needed);
  NodeId asked_at(Node const &decision, NodeId yes, NodeId no);

  Graph merged_; // that of the first path, except its nodes
  NodeTable table_;
  std::map<std::vector<std::uint64_t>, LocationId> locations_; // by addresses
  std::vector<LocationId> node_location_;
  std::vector<char> node_exact_;
  std::vector<Node> tree_;          // parents precede their branches; empty without paths
  std::map<NodeId, Needed> needed_; // by condition
  std::size_t selects_ = 0, open_branches_ = 0, unmet_ = 0, assumed_ = 0, by_range_ = 0;
};

} // namespace symreal::program
