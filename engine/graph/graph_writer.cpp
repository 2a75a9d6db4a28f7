#include "engine/graph/graph_line.h"
#include "engine/graph/graph_text.h"
#include "engine/support/number.h"

#include <ostream>

namespace symreal {

namespace {

void write_place(std::ostream &out, Place const &place) {
  if (!place.file.empty()) out << " at " << in_quotes(place.file) << ' ' << place.line << ' ' << place.column;
}

void write_shape(std::ostream &out, std::vector<std::size_t> const &extents, std::vector<Member> const &members) {
  for (std::size_t extent : extents) out << " [" << extent << ']';
  if (members.empty()) return;
  out << " {";
  for (Member const &member : members) {
    out << ' ' << in_quotes(member.name);
    write_shape(out, member.extents, member.members);
  }
  out << " }";
}

void write_objects(std::ostream &out, char const *role, std::vector<Object> const &objects,
                   std::vector<double> const *values) {
  for (Object const &object : objects) {
    out << role << ' ' << in_quotes(object.label);
    write_shape(out, object.extents, object.members);
    write_place(out, object.place);
    if (object.range) out << " range " << shortest(object.range->low) << ' ' << shortest(object.range->high);
    if (values) {
      out << " =";
      for (std::uint32_t k = 0; k < object.count; ++k) out << ' ' << shortest((*values)[object.first + k]);
    }
    out << '\n';
  }
}

void write_location(std::ostream &out, std::size_t id, Location const &location) {
  out << "location " << id;
  for (Place const &place : location.places) write_place(out, place);
  if (!location.addresses.empty()) out << " stack";
  for (std::uint64_t address : location.addresses) out << ' ' << address;
  out << '\n';
}

void write_value(std::ostream &out, ExternalValue const &value) {
  out << ' ' << kind_names[static_cast<std::size_t>(value.kind)];
  if (value.kind == ExternalValue::Kind::integer)
    out << ' ' << in_quotes(value.type);
  else if (value.kind != ExternalValue::Kind::number)
    out << ' ' << value.count;
}

void write_tables(std::ostream &out, std::vector<Table> const &tables) {
  for (std::size_t k = 0; k < tables.size(); ++k) {
    out << "table " << k << ' ' << in_quotes(tables[k].name);
    for (std::size_t extent : tables[k].extents) out << " [" << extent << ']';
    write_place(out, tables[k].place);
    out << " =";
    for (double value : tables[k].values) out << ' ' << shortest(value);
    out << '\n';
  }
}

void write_externals(std::ostream &out, std::vector<External> const &externals) {
  for (std::size_t k = 0; k < externals.size(); ++k) {
    External const &external = externals[k];
    out << "external " << k << ' ' << in_quotes(external.name);
    if (external.pure) out << " pure";
    if (external.returned.kind != ExternalValue::Kind::none) {
      out << " returns";
      write_value(out, external.returned);
    }
    if (!external.parameters.empty()) out << " takes";
    for (ExternalValue const &parameter : external.parameters) write_value(out, parameter);
    for (auto const &[name, is_returned] : external.derivatives)
      out << (is_returned ? " derivative returned " : " derivative ") << in_quotes(name);
    write_place(out, external.place);
    out << '\n';
  }
}

} // namespace

std::vector<NodeId> line_numbers(Graph const &graph) {
  std::vector<NodeId> number(graph.nodes.size(), no_node);
  NodeId next = 0;
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (!graph.nodes[id].is_constant()) number[id] = next++;
  return number;
}

void write_graph(std::ostream &out, Graph const &graph) {
  out << "symreal-graph 1\nkernel " << in_quotes(graph.kernel) << '\n';
  if (graph.decisions != "error") out << "decisions " << graph.decisions << '\n';
  if (graph.from_instructions) out << "from instructions\n";
  write_objects(out, "input", graph.inputs, &graph.input_values);
  write_objects(out, "parameter", graph.parameters, &graph.parameter_values);
  write_objects(out, "output", graph.outputs, nullptr);
  for (StatePair const &pair : graph.states) {
    out << "state " << in_quotes(pair.state) << ' ' << in_quotes(pair.derivative);
    write_place(out, pair.place);
    out << '\n';
  }
  for (DerivativeWish const &wish : graph.wishes) {
    out << "differentiate " << in_quotes(wish.text);
    write_place(out, wish.place);
    out << '\n';
  }
  for (std::string const &derivative : graph.derivatives) out << "derivative " << in_quotes(derivative) << '\n';
  for (DerivativeMatrix const &matrix : graph.matrices) {
    out << "matrix " << matrix.output << " [" << matrix.rows << "] [" << matrix.columns << ']'
        << (matrix.is_packed ? " packed" : "") << (matrix.is_symmetric ? " symmetric" : "") << " =";
    for (std::size_t k = 0; k < matrix.row.size(); ++k) out << ' ' << matrix.row[k] << ' ' << matrix.column[k];
    out << '\n';
  }
  for (Frozen const &frozen : graph.frozen) {
    out << "frozen " << in_quotes(frozen.name);
    write_place(out, frozen.place);
    if (frozen.is_around) out << " around";
    if (frozen.is_member) out << " member";
    out << " =";
    for (double value : frozen.values) out << ' ' << shortest(value);
    out << '\n';
  }
  write_tables(out, graph.tables);
  write_externals(out, graph.externals);
  for (std::size_t id = 0; id < graph.locations.size(); ++id) write_location(out, id, graph.locations[id]);
  for (OperationInfo const &operation : operations())
    if (std::size_t count = graph.executed[operation.op]) out << "executed " << operation.name << ' ' << count << '\n';

  std::vector<NodeId> const number = line_numbers(graph);
  auto spell = [&](NodeId id) {
    Node const &node = graph.nodes[id];
    return node.is_constant() ? shortest(node.value()) : "%" + std::to_string(number[id]);
  };
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (node.is_constant()) continue;
    out << '%' << number[id] << " = ";
    if (is_leaf(node.op)) {
      out << (node.op == Op::input ? "input " : "parameter ") << node.slot() << '\n';
      continue;
    }
    out << info(node.op).name;
    for (NodeId operand : node.operand)
      if (operand != no_node) out << ' ' << spell(operand);
    if (!graph.node_exact.empty() && graph.node_exact[id]) out << " exact";
    if (!graph.node_location.empty() && graph.node_location[id] != no_location) out << " @" << graph.node_location[id];
    if (!graph.node_name.empty() && graph.node_name[id] != no_name)
      out << ' ' << in_quotes(graph.names[graph.node_name[id]]);
    out << '\n';
  }
  for (std::size_t slot = 0; slot < graph.results.size(); ++slot)
    out << "result " << slot << ' ' << spell(graph.results[slot]) << '\n';
  for (std::size_t k = 0; k < graph.guards.size(); ++k) {
    Guard const &guard = graph.guards[k];
    out << "guard " << k << ' ' << spell(guard.condition);
    if (guard.location != no_location) out << " @" << guard.location;
    out << ' ' << in_quotes(guard.text) << '\n';
  }
  if (graph.last_effect != no_node) out << "effect " << spell(graph.last_effect) << '\n';
  for (std::size_t slot = 0; slot < graph.precomputed.size(); ++slot)
    out << "precomputed " << slot << ' ' << spell(graph.precomputed[slot]) << '\n';
}

} // namespace symreal
