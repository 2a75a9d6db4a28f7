// Lines and names of a plan's text. Internal to the readers of plan_text.h.
#pragma once

#include "engine/graph/graph_line.h"
#include "engine/plan/plan.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// The lines of a text, with their numbers; the first has number `number` + 1.
class Lines {
public:
  Lines(std::string_view text, std::string const &file_name, unsigned number)
      : rest_(text),
        file_name_(file_name),
        number_(number) {}

  bool done() const { return rest_.empty(); }
  unsigned number() const { return number_; }
  std::string_view next();
  Place place() const { return {file_name_, number_, 0}; }

private:
  std::string_view rest_;
  std::string const &file_name_;
  unsigned number_;
};

// Names of a graph's nodes: %4, or a constant.
class NodeNames {
public:
  explicit NodeNames(Graph const &graph);

  NodeId find(Line &line, std::string const &word) const;

private:
  Graph const &graph_;
  std::vector<NodeId> nodes_; // node of each %k
};

// The enumerator of this name; nullopt if the name is unknown. `names`: those of the enumerators, in order.
template <class Enum> std::optional<Enum> find_name(std::span<std::string_view const> names, std::string_view name) {
  auto const found = std::ranges::find(names, name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

} // namespace symreal
