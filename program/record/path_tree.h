// The recorded paths of one kernel as one graph: equal nodes of all paths are one node, and each output is a tree of
// selects over what the paths give. A select between equal values is none. Where a path is missing the tree is open,
// and a guard for each such branch keeps callers away from it.
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
  NodeId condition; // in the graph of the path
  bool outcome;
  bool is_assumed;  // the other outcome is not to be tried
  bool is_joined;   // both are recorded, and have come together
  std::string text; // of the condition
  std::vector<std::uint64_t> addresses = {};
  bool is_by_range = false;      // assumed: the other outcome lies beyond an input's range
  bool is_met[2] = {true, true}; // by outcome: otherwise no given sample that comes by has it
};

struct RecordedPath {
  Graph graph; // without outputs if it is cut off
  std::vector<DecidedStep> steps;
  bool is_cut_off = false;
};

using Outcomes = std::string; // t, f, or j for a decision whose ways have come together

class PathTree {
public:
  PathTree();

  // False where the path decides on another value than those that begin like it: the program does not repeat itself.
  bool add(RecordedPath path);

  // The next path of a search in depth: it begins with these outcomes, the last of which no path has taken. None for
  // what no sample meets.
  std::optional<Outcomes> next() const;

  // The graph of the whole. The tree is spent.
  Graph merge();

  // After `merge`: the selects between paths, and the branches that are open.
  std::size_t selects() const { return selects_; }
  std::size_t open_branches() const { return open_branches_; }
  // Those that no given sample takes, which are not counted among these.
  std::size_t unmet() const { return unmet_; }
  // Where the program decides, each once, but for what is assumed.
  std::vector<std::vector<std::uint64_t>> decided_at() const;
  // Those whose other side was not to be tried, which are not counted among these.
  std::size_t assumed() const { return assumed_; }
  std::size_t assumed_by_range() const { return by_range_; }

private:
  static constexpr std::size_t none = ~std::size_t{0};
  // A decision, or the end of a path.
  struct Node {
    std::size_t parent = none;
    bool branch_of_parent = false;
    NodeId condition = no_node; // in the merged graph; none: a path ends here
    LocationId location = no_location;
    std::string text = {};
    std::size_t branches[2] = {none, none}; // by outcome
    bool is_assumed = false, is_joined = false, is_by_range = false;
    bool is_met[2] = {false, false};
    bool is_open = true; // nothing below comes to the kernel's end
    std::vector<NodeId> results = {};
    std::vector<Guard> guards = {}; // of the path that ends here
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

  // A guard, and the nodes of the tree from which on it is needed.
  struct Needed {
    Guard guard;
    std::vector<std::size_t> at;
  };
  // path_guards.cpp
  void need(Guard guard, std::size_t at);
  void add_guards();
  std::string where(std::size_t at) const;
  NodeId asked_at_root(Needed const &needed);
  NodeId asked_at(Node const &decision, NodeId yes, NodeId no);

  Graph merged_; // of the first path, but for its nodes
  NodeTable table_;
  std::map<std::vector<std::uint64_t>, LocationId> locations_; // by addresses
  std::vector<LocationId> node_location_;
  std::vector<char> node_exact_;
  std::vector<Node> tree_;          // a parent comes before its branches; empty as long as there is no path
  std::map<NodeId, Needed> needed_; // by condition
  std::size_t selects_ = 0, open_branches_ = 0, unmet_ = 0, assumed_ = 0, by_range_ = 0;
};

} // namespace symreal::program
