#include "engine/graph/graph.h"

#include "engine/support/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace symreal {

// Out of line, since code compiled without optimisation copies and destroys graphs too.
Graph::Graph() = default;
Graph::Graph(Graph const &) = default;
Graph::Graph(Graph &&) noexcept = default;
Graph &Graph::operator=(Graph const &) = default;
Graph &Graph::operator=(Graph &&) noexcept = default;
Graph::~Graph() = default;

std::size_t number_count(std::vector<std::size_t> const &extents, std::vector<Member> const &members) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t count = members.empty() ? 1 : 0;
  for (Member const &member : members)
    if (__builtin_add_overflow(count, number_count(member.extents, member.members), &count)) count = most;
  for (std::size_t const extent : extents)
    if (__builtin_mul_overflow(count, extent, &count)) count = most;
  return count;
}

// Finds an object by its label, or by its name: "x[0:2]" or x.
static std::size_t find(std::vector<Object> const &objects, std::string const &name) {
  auto const is_meant = [&](Object const &object) {
    return object.label == name || object.label.substr(0, object.label.find('[')) == name;
  };
  return static_cast<std::size_t>(std::ranges::find_if(objects, is_meant) - objects.begin());
}

std::vector<State> find_states(Graph const &graph) {
  std::vector<State> states;
  for (StatePair const &pair : graph.states) {
    auto const require = [&](bool holds, std::string const &why) {
      if (!holds)
        fail(DiagnosticId::pragma_syntax, pair.place, "state(" + pair.state + ", " + pair.derivative + "): " + why);
    };
    State const state{find(graph.inputs, pair.state), find(graph.outputs, pair.derivative)};
    require(state.input != graph.inputs.size(),
            "'" + pair.state + "' is not an input of kernel '" + graph.kernel + "'");
    require(state.output != graph.outputs.size(),
            "'" + pair.derivative + "' is not an output of kernel '" + graph.kernel + "'");
    Object const &input = graph.inputs[state.input], &output = graph.outputs[state.output];
    require(input.extents == output.extents && input.members == output.members, "they have different shapes");
    for (State const &other : states)
      require(other.input != state.input && other.output != state.output, "another state(...) names one of them");
    states.push_back(state);
  }
  std::ranges::sort(states, {}, &State::input);
  return states;
}

std::string value_list(std::vector<double> const &values) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < values.size() && i < most; ++i) text += (i ? ", " : "") + shortest(values[i]);
  return values.size() > most ? fmt::format("{}, ... ({} in all)", text, values.size()) : text;
}

std::optional<Severity> frozen_severity(Frozen const &state, std::string const &policy) {
  if (policy == "allow" || state.is_member || (state.is_around && policy == "state")) return {};
  return policy == "warn" ? Severity::warning : Severity::error;
}

std::string frozen_message(std::string const &kernel, Frozen const &state) {
  std::string const values = state.values.empty() ? "" : " (" + value_list(state.values) + ")";
  return fmt::format("kernel '{}' reads '{}'{}, which {} neither input nor parameter", kernel, state.name, values,
                     state.values.size() > 1 ? "are" : "is");
}

Place place_at(Graph const &graph, LocationId location) {
  if (location == no_location || graph.locations[location].places.empty()) return {};
  return graph.locations[location].places.front();
}

Place place_of(Graph const &graph, NodeId node) {
  return place_at(graph, node < graph.node_location.size() ? graph.node_location[node] : no_location);
}

Graph without_nodes(Graph const &graph) {
  Graph rest;
  rest.kernel = graph.kernel;
  rest.inputs = graph.inputs;
  rest.parameters = graph.parameters;
  rest.outputs = graph.outputs;
  rest.states = graph.states;
  rest.wishes = graph.wishes;
  rest.derivatives = graph.derivatives;
  rest.derivatives_alone = graph.derivatives_alone;
  rest.matrices = graph.matrices;
  rest.input_values = graph.input_values;
  rest.parameter_values = graph.parameter_values;
  rest.frozen = graph.frozen;
  rest.executed = graph.executed;
  rest.decisions = graph.decisions;
  rest.from_instructions = graph.from_instructions;
  rest.locations = graph.locations;
  rest.names = graph.names;
  rest.tables = graph.tables;
  rest.externals = graph.externals;
  return rest;
}

// A per-node column after node `id` became `now[id]`; of several nodes that became one, the oldest gives the entry.
template <class Column> static Column moved(Column const &column, std::vector<NodeId> const &now, std::size_t size,
                                            typename Column::value_type none) {
  Column result(size, none);
  for (std::size_t id = 0; id < now.size(); ++id)
    if (now[id] != no_node && result[now[id]] == none) result[now[id]] = column[id];
  return result;
}

// Gives auxiliary nodes of a pass the location of the node that they were made for.
static void locate_others(Graph &graph) {
  LongArray<LocationId> &locations = graph.node_location;
  for (std::size_t id = locations.size(); id-- > 1;)
    if (locations[id - 1] == no_location && !is_leaf(graph.nodes[id - 1].op)) locations[id - 1] = locations[id];
}

void carry_over(Graph const &graph, std::vector<NodeId> const &now, Graph &result) {
  for (NodeId root : graph.results) result.results.push_back(now[root]);
  for (NodeId root : graph.precomputed) result.precomputed.push_back(now[root]);
  for (Guard const &guard : graph.guards) result.guards.push_back({now[guard.condition], guard.location, guard.text});
  if (graph.last_effect != no_node) result.last_effect = now[graph.last_effect];
  if (!graph.node_location.empty()) {
    result.node_location = moved(graph.node_location, now, result.nodes.size(), no_location);
    locate_others(result);
  }
  if (!graph.node_name.empty()) result.node_name = moved(graph.node_name, now, result.nodes.size(), no_name);
  if (!graph.node_exact.empty()) {
    std::vector<char> const made = std::move(result.node_exact); // set by the pass for nodes that replace others
    result.node_exact = moved(graph.node_exact, now, result.nodes.size(), char{0});
    for (std::size_t id = 0; id < made.size(); ++id) result.node_exact[id] |= made[id];
  }
}

std::vector<char> recomputed_nodes(Graph const &graph) {
  std::vector<char> needed(graph.nodes.size(), 0), stored(graph.nodes.size(), 0);
  if (graph.precomputed.empty()) return needed;
  for_each_root(graph, [&](NodeId root) { needed[root] = 1; });
  for (NodeId id : graph.precomputed) stored[id] = 1;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!needed[id] || stored[id] || is_leaf(node.op)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) needed[operand] = 1;
  }
  for (std::size_t id = 0; id < needed.size(); ++id) {
    Node const &node = graph.nodes[id];
    needed[id] = needed[id] && !stored[id] && !is_leaf(node.op) && !info(node.op).has(flag::STRUCTURE) &&
                 node.attribute == Attribute::parametric;
  }
  return needed;
}

void keep_nodes(Graph &graph, std::vector<char> const &kept) {
  std::vector<NodeId> now(graph.nodes.size(), no_node);
  NodeId count = 0;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!kept[id]) continue;
    Node node = graph.nodes[id];
    if (!is_leaf(node.op))
      for (NodeId &operand : node.operand)
        if (operand != no_node) operand = now[operand];
    now[id] = count;
    graph.nodes[count++] = node;
  }
  auto const keep = [&](auto &column) {
    if (column.empty()) return;
    for (std::size_t id = 0; id < kept.size(); ++id)
      if (kept[id]) column[now[id]] = column[id];
    column.resize(count);
  };
  graph.nodes.resize(count);
  keep(graph.node_location);
  keep(graph.node_name);
  keep(graph.node_exact);
  locate_others(graph);
  for (NodeId &root : graph.results) root = now[root];
  for (NodeId &root : graph.precomputed) root = now[root];
  for (Guard &guard : graph.guards) guard.condition = now[guard.condition];
  if (graph.last_effect != no_node) graph.last_effect = now[graph.last_effect];
}

void mark_operands(Graph const &graph, std::vector<char> &marked) {
  // Operands precede users, so one backward sweep meets every user before its operands.
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    Node const &node = graph.nodes[id];
    if (!marked[id] || is_leaf(node.op)) continue;
    for (NodeId operand : node.operand)
      if (operand != no_node) marked[operand] = 1;
  }
}

std::vector<char> live_nodes(Graph const &graph) {
  std::vector<char> live(graph.nodes.size(), 0);
  for_each_root(graph, [&](NodeId root) { live[root] = 1; });
  mark_operands(graph, live);
  return live;
}

std::vector<NodeId> arguments_of(Graph const &graph, NodeId list) {
  std::vector<NodeId> values;
  for (; graph.nodes[list].op == Op::argument; list = graph.nodes[list].operand[0])
    values.push_back(graph.nodes[list].operand[1]);
  std::reverse(values.begin(), values.end());
  return values;
}

} // namespace symreal
