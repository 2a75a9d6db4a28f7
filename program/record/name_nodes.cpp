#include "program/record/name_nodes.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace symreal::program {
namespace {

using Position = std::tuple<std::string, unsigned, unsigned>;

Position position(Place const &place) { return {place.file, place.line, place.column}; }

// Finds the innermost statement around a place: the one that begins last, since statements nest or are disjoint.
class Statements {
public:
  explicit Statements(std::vector<rewrite::NamedStatement> const &statements) {
    for (rewrite::NamedStatement const &statement : statements) by_begin_[position(statement.begin)] = &statement;
  }

  rewrite::NamedStatement const *around(Place const &place) const {
    constexpr int most_nested = 8; // nesting of assignments in values
    auto at = by_begin_.upper_bound(position(place));
    for (int i = 0; i < most_nested && at != by_begin_.begin(); ++i) {
      --at;
      if (position(at->second->end) >= position(place)) return at->second;
    }
    return nullptr;
  }

private:
  std::map<Position, rewrite::NamedStatement const *> by_begin_;
};

} // namespace

void name_nodes(Graph &graph, std::vector<rewrite::NamedStatement> const &all) {
  if (graph.node_location.empty()) return;
  Statements const statements(all);
  std::vector<rewrite::NamedStatement const *> by_location;
  for (Location const &location : graph.locations)
    by_location.push_back(location.places.empty() ? nullptr : statements.around(location.places.front()));

  std::map<std::string, NameId> known;
  graph.node_name.assign(graph.nodes.size(), no_name);
  auto statement_of = [&](std::size_t id) -> rewrite::NamedStatement const * {
    LocationId location = graph.node_location[id];
    return location == no_location ? nullptr : by_location[location];
  };
  rewrite::NamedStatement const *following = nullptr; // statement of the following operation
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (is_leaf(graph.nodes[id].op)) continue;
    rewrite::NamedStatement const *statement = statement_of(id);
    if (statement && statement != following) {
      auto [found, is_new] = known.try_emplace(statement->name, static_cast<NameId>(graph.names.size()));
      if (is_new) graph.names.push_back(statement->name);
      graph.node_name[id] = found->second;
    }
    following = statement;
  }
}

} // namespace symreal::program
