// Reader of a function's statements, with their regions, gates, checks and stores. Internal to plan_text.h.
#pragma once

#include "engine/plan/text/lines.h"

namespace symreal {

class StatementReader {
public:
  // `computed`: per node, whether a helper that the function calls computes it; or empty.
  StatementReader(Plan &plan, PlanFunction &function, NodeNames const &names, std::vector<char> computed = {});

  // Reads a line, of which `head` is the first word; false if it is of another kind.
  bool read(std::string const &head, Line &line);
  // Checks what can be wrong only where all statements are read.
  void finish(Line &line);
  // Per node: whether the function computes it.
  std::vector<char> computed() const;

private:
  void read_region(Line &line);
  void read_gate(Line &line);
  void read_circle(Op op, Line &line);
  void read_set(Line &line);
  void read_check(Line &line);
  void read_part(Line &line);
  void read_store(Line &line);

  RegionId read_region_use(Line &line) const;
  void read_kind(Line &line, NodeId id) const;
  // Parses %4, ?0, or a constant of the graph.
  NodeId value(Line &line, std::string const &word) const;

  bool is_compute() const { return function_.kind == FunctionKind::compute; }
  std::size_t returned_count(NodeId call) const;
  void require_number(Line const &line, NodeId id) const;
  // Checks that the node may follow `set`.
  void require_statement(Line const &line, NodeId id) const;
  void require_visible(Line const &line, NodeId id) const;
  // Checks that all variables of a use are set above, and all calls: a call cannot be nested.
  void require_set(Line &line, NodeId use);
  // Checks that a call set above keeps this result.
  void require_returned(Line const &line, Node const &node) const;
  // Checks the outputs, which are stored at the end, after all reads of inputs.
  void require_results(Line &line);

  Plan &plan_;
  Graph const &graph_;
  PlanFunction &function_;
  NodeNames const &names_;
  std::vector<char> computed_;
  std::size_t angles_ = 0;           // read so far
  std::vector<char> is_set_, gates_; // by a statement above
  std::vector<char> is_nested_;      // in a statement above
};

} // namespace symreal
