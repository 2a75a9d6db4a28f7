#include "engine/graph/validate.h"

#include "engine/graph/implicit.h"
#include "engine/graph/names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace symreal {

namespace {

using Kind = ExternalValue::Kind;

// Integer types as compilers spell them.
constexpr auto integer_types = std::to_array<std::string_view>(
    {"_Bool", "char", "signed char", "unsigned char", "short", "unsigned short", "int", "unsigned int", "long",
     "unsigned long", "long long", "unsigned long long", "__int128", "unsigned __int128"});

std::string type_violation(ExternalValue const &value) {
  if (value.kind == Kind::integer && std::ranges::find(integer_types, value.type) == integer_types.end())
    return "'" + value.type + "' is not a type of integers, as in \"unsigned int\"";
  if (value.kind != Kind::none && value.count == 0) return "an object without doubles cannot be a parameter";
  return {};
}

// Whether C accepts the name: letters, digits and underscores, other than a keyword.
bool is_c_identifier(std::string_view name) {
  static constexpr auto keywords = std::to_array<std::string_view>(
      {"_Bool",  "_Complex", "_Imaginary", "auto",     "break",  "case",     "char",   "const",  "continue", "default",
       "do",     "double",   "else",       "enum",     "extern", "float",    "for",    "goto",   "if",       "inline",
       "int",    "long",     "register",   "restrict", "return", "short",    "signed", "sizeof", "static",   "struct",
       "switch", "typedef",  "union",      "unsigned", "void",   "volatile", "while"});
  static_assert(std::ranges::is_sorted(keywords));
  return is_identifier(name) && !std::ranges::binary_search(keywords, name);
}

bool is_of_numbers(External const &external, unsigned arity) {
  ExternalValue const number{Kind::number};
  return external.returned == number && external.parameters == std::vector(arity, number);
}

// Whether C declares both alike, as functions of one name must be.
bool has_prototype_of(External const &a, External const &b) {
  // The number of elements behind a pointer is not part of a prototype, nor whether they are read.
  auto const is_alike = [](ExternalValue const &x, ExternalValue const &y) {
    bool const are_written = x.kind != Kind::input && x.is_pointer() && y.kind != Kind::input && y.is_pointer();
    return are_written || (x.kind == y.kind && x.type == y.type && (x.kind != Kind::object || x.count == y.count));
  };
  return is_alike(a.returned, b.returned) && std::ranges::equal(a.parameters, b.parameters, is_alike);
}

// Functions of <math.h> that are not operations, with their types as in the table.
struct MathFunction {
  std::string_view name, types;
};
constexpr auto math_functions = std::to_array<MathFunction>({
#define MATH_FUNCTION(name, types, numbers) {#name, types},
#include <symreal/math_functions.def>
#undef MATH_FUNCTION
});

bool is_of_type(ExternalValue const &value, char type) {
  switch (type) {
  case 'n': return value.kind == Kind::number;
  case 'i': return value.kind == Kind::integer && value.type == "int";
  case 'l': return value.kind == Kind::integer && value.type == "long";
  case 'L': return value.kind == Kind::integer && value.type == "long long";
  case 'N': return value.is_pointer() && value.kind != Kind::input;
  default: return false;
  }
}

// Generated code includes <math.h>, so that a function of its name must have its prototype.
std::string math_violation(External const &external) {
  std::string_view const name = external.name;
  auto const is_narrow_or_wide = [&](std::string_view base) {
    return name.size() == base.size() + 1 && name.starts_with(base) && (name.back() == 'f' || name.back() == 'l');
  };
  auto const of_math = [&](std::string const &what) {
    return "'" + external.name + "' is a function of <math.h>, " + what;
  };
  for (OperationInfo const &operation : operations()) {
    if (operation.form != Form::call) continue;
    if (operation.c == name && !is_of_numbers(external, operation.arity))
      return of_math("which takes " + std::to_string(operation.arity) +
                     (operation.arity == 1 ? " number" : " numbers") + " and returns one");
    if (is_narrow_or_wide(operation.c)) return of_math("and its numbers are not of type double");
  }
  for (MathFunction const &function : math_functions) {
    if (function.types.empty()) continue;
    if (is_narrow_or_wide(function.name)) return of_math("and its numbers are not of type double");
    if (function.name != name) continue;
    bool const is_alike = external.parameters.size() + 1 == function.types.size() &&
                          is_of_type(external.returned, function.types[0]) &&
                          std::ranges::equal(external.parameters, function.types.substr(1), is_of_type);
    if (!is_alike) return of_math("with other types");
  }
  return {};
}

std::string check_objects(std::vector<Object> const &objects) {
  std::uint32_t next = 0;
  for (Object const &object : objects) {
    if (object.range && !is_range(*object.range)) return "the range of '" + object.label + "' holds no number";
    if (object.first != next || object.count != number_count(object.extents, object.members))
      return "object '" + object.label + "' does not fit its slots";
    next += object.count;
  }
  return {};
}

// Flags of operations with further checks, also for their users.
constexpr unsigned demanding = flag::WIDE | flag::TAKES_WIDE | flag::STRUCTURE | flag::OPAQUE;

// Fast path for most nodes of most graphs: a sum, difference, product or quotient of two numbers.
bool is_sound_arithmetic(Nodes const &nodes, NodeId id) {
  static constexpr auto plain = [] { // operations without further checks, and leaves
    std::array<bool, static_cast<std::size_t>(Op::count)> result{};
    result.fill(true);
    for (OperationInfo const &row : detail::operation_table)
      result[static_cast<std::size_t>(row.op)] = !row.has(demanding);
    return result;
  }();
  Node const &node = nodes[id];
  if (node.op != Op::add && node.op != Op::sub && node.op != Op::mul && node.op != Op::div) return false;
  auto const [a, b, none] = node.operand;
  if (a >= id || b >= id || none != no_node) return false;
  return plain[static_cast<std::size_t>(nodes[a].op)] && plain[static_cast<std::size_t>(nodes[b].op)] &&
         node.attribute == std::max(nodes[a].attribute, nodes[b].attribute);
}

std::string check_matrix(DerivativeMatrix const &matrix, std::vector<Object> const &outputs) {
  if (matrix.output >= outputs.size()) return "a matrix names an output that does not exist";
  std::size_t const whole = std::size_t{matrix.rows} * matrix.columns, count = matrix.row.size();
  if (matrix.column.size() != count || outputs[matrix.output].count != (matrix.is_packed ? count : whole))
    return "a matrix does not fit its output";
  for (std::size_t k = 0; k < count; ++k) {
    if (matrix.row[k] >= matrix.rows || matrix.column[k] >= matrix.columns) return "a matrix has no such row or column";
    if (k > 0 && std::pair(matrix.row[k - 1], matrix.column[k - 1]) >= std::pair(matrix.row[k], matrix.column[k]))
      return "the elements of a matrix do not stand row by row";
  }
  return {};
}

Attribute attribute_of_leaf(Op op) {
  return op == Op::constant ? Attribute::constant : op == Op::parameter ? Attribute::parametric : Attribute::variable;
}

// Whether the node is a constant index below `end`.
bool is_number_below(Graph const &graph, NodeId id, std::size_t end) {
  Node const &node = graph.nodes[id];
  if (!node.is_constant()) return false;
  double const value = node.value();
  return value >= 0 && value < static_cast<double>(end) && value == std::floor(value);
}

bool is_structure(Graph const &graph, NodeId id) {
  Op const op = graph.nodes[id].op;
  return !is_leaf(op) && info(op).has(flag::STRUCTURE);
}

bool is_list(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  return node.op == Op::argument || (node.is_constant() && node.value() == 0);
}

char const *lookup_violation(Graph const &graph, Node const &node) {
  if (!is_number_below(graph, node.operand[0], graph.tables.size())) return "reads a table that does not exist";
  std::size_t const indices = node.op == Op::lookup ? 1 : 2;
  return graph.tables[table_of(graph, node)].extents.size() == indices ? nullptr
                                                                       : "has not as many indices as its table";
}

// Whether constant arguments are integers where the function takes integers.
bool fit(Graph const &graph, External const &external, std::vector<NodeId> const &arguments) {
  std::size_t next = 0;
  for (ExternalValue const &parameter : external.parameters) {
    if (!parameter.is_given()) continue;
    Node const &argument = graph.nodes[arguments[next]];
    if (parameter.kind == ExternalValue::Kind::integer && argument.is_constant()) {
      double const value = argument.value();
      if (value != std::trunc(value) || !(std::fabs(value) < 0x1p127)) return false;
    }
    next += parameter.count;
  }
  return true;
}

char const *call_violation(Graph const &graph, Node const &node) {
  if (!is_number_below(graph, node.operand[1], graph.externals.size())) return "calls a function that does not exist";
  if (!is_list(graph, node.operand[0])) return "has no list of arguments";
  External const &external = graph.externals[function_of(graph, node)];
  if (external.pure != (node.op == Op::call)) return "is not the kind of call that its function needs";
  std::vector<NodeId> const arguments = arguments_of(graph, node.operand[0]);
  if (arguments.size() != external.argument_count()) return "has not as many arguments as its function takes";
  if (!fit(graph, external, arguments)) return "hands over a number that its function's integer cannot be";
  if (node.op == Op::call) return nullptr;
  Node const &before = graph.nodes[node.operand[2]];
  bool const is_first = before.is_constant() && before.value() == 0;
  return is_first || before.op == Op::call_in_order ? nullptr : "follows something other than a call in order";
}

char const *returned_violation(Graph const &graph, Node const &node) {
  Node const &call = graph.nodes[node.operand[0]];
  if (!is_call(call.op)) return "is a result of something other than a call";
  std::size_t const results = graph.externals[function_of(graph, call)].result_count();
  return is_number_below(graph, node.operand[1], results) ? nullptr : "is a result that its function does not have";
}

// Description of a violated invariant of an opaque node, or nullptr. Argument lists and calls may only be operands of
// the operations that they belong to.
char const *find_opaque_violation(Graph const &graph, NodeId id) {
  Node const &node = graph.nodes[id];
  char const *what = nullptr;
  std::size_t first_value = 0; // index of the first operand that must be a number
  switch (node.op) {
  case Op::lookup:
  case Op::lookup2: what = lookup_violation(graph, node); break;
  case Op::argument:
    if (!is_list(graph, node.operand[0])) what = "extends something other than a list of arguments";
    first_value = 1;
    break;
  case Op::call:
  case Op::call_in_order:
    what = call_violation(graph, node);
    first_value = arity(node.op);
    break;
  case Op::returned:
    what = returned_violation(graph, node);
    first_value = arity(node.op);
    break;
  default: break;
  }
  for (std::size_t i = first_value; i < arity(node.op); ++i)
    if (is_structure(graph, node.operand[i])) what = "computes with something other than a number";
  return what;
}

// Description of the violation, or nullptr.
char const *find_node_violation(Graph const &graph, NodeId id) {
  if (is_sound_arithmetic(graph.nodes, id)) return nullptr;
  Node const &node = graph.nodes[id];
  if (node.op >= Op::count) return "has no operation";
  if (is_leaf(node.op) && node.attribute != attribute_of_leaf(node.op)) return "has the wrong attribute";
  if (node.op == Op::input) return node.slot() < graph.input_count() ? nullptr : "names an input that does not exist";
  if (node.op == Op::parameter)
    return node.slot() < graph.parameter_count() ? nullptr : "names a parameter that does not exist";
  if (is_leaf(node.op)) return nullptr;
  OperationInfo const &operation = info(node.op);
  Attribute attribute = Attribute::constant;
  unsigned flags = operation.flags; // united with those of the operands
  for (std::size_t i = 0; i < node.operand.size(); ++i) {
    if ((i < operation.arity) != (node.operand[i] != no_node)) return "has the wrong number of operands";
    if (i >= operation.arity) continue;
    if (node.operand[i] >= id) return "is older than its operand";
    Node const &operand = graph.nodes[node.operand[i]];
    if (!is_leaf(operand.op)) flags |= info(operand.op).flags;
    attribute = std::max(attribute, operand.attribute);
  }
  if (node.attribute != attribute_of(node.op, attribute)) return "has the wrong attribute";
  if (!(flags & demanding)) return nullptr;
  for (std::size_t i = 0; i < operation.arity; ++i)
    if (is_wide(graph.nodes[node.operand[i]].op) != takes_wide(node.op, i))
      return takes_wide(node.op, i) ? "takes integers of 64 bits" : "takes no integers of 64 bits";
  return find_opaque_violation(graph, id);
}

std::string check_table(Table const &table) {
  std::size_t count = 1;
  for (std::size_t extent : table.extents)
    if (__builtin_mul_overflow(count, extent, &count)) count = 0;
  bool const is_one = !table.extents.empty() && table.extents.size() <= 2 && count != 0;
  return is_one && table.values.size() == count ? "" : "table '" + table.name + "' does not fit its extents";
}

std::string check_externals(std::vector<External> const &externals) {
  for (External const &external : externals) {
    if (is_implicit(external) && !is_well_formed_implicit(external)) return "'implicit function' has another form";
    if (is_implicit(external)) continue;
    if (std::string violation = find_violation(external); !violation.empty()) return violation;
    auto const first = std::ranges::find(externals, external.name, &External::name);
    if (!has_prototype_of(*first, external))
      return "function '" + external.name + "' is declared once more, and otherwise";
  }
  return {};
}

// Ordered calls form one chain that ends in the last effect; a call outside it would be lost.
std::string check_effects(Graph const &graph) {
  auto const is_effect = [&](NodeId id) { return id < graph.nodes.size() && graph.nodes[id].op == Op::call_in_order; };
  if (graph.last_effect != no_node && !is_effect(graph.last_effect)) return "the last effect is not a call in order";
  std::size_t effects = 0, reached = 0;
  for (Node const &node : graph.nodes) effects += node.op == Op::call_in_order;
  for (NodeId id = graph.last_effect; id != no_node && is_effect(id); id = graph.nodes[id].operand[2]) ++reached;
  return reached == effects ? "" : "a call in order does not stand before the last effect";
}

// Whether the node is a number, as results, guards and `constants` must be.
bool is_number(Graph const &graph, NodeId id) {
  Op const op = graph.nodes[id].op;
  return is_leaf(op) || !info(op).has(flag::WIDE | flag::STRUCTURE);
}

std::string check_roots(Graph const &graph) {
  for (auto const *roots : {&graph.results, &graph.precomputed})
    for (NodeId root : *roots)
      if (root >= graph.nodes.size()) return "a result names a node that does not exist";
  for (NodeId result : graph.results)
    if (!is_number(graph, result)) return "a result is not a number";
  for (NodeId stored : graph.precomputed) {
    if (graph.nodes[stored].attribute != Attribute::parametric) return "a precomputed node is not parametric";
    if (!is_number(graph, stored) && !is_wide(graph.nodes[stored].op)) return "a precomputed node is not a number";
  }
  for (Guard const &guard : graph.guards) {
    if (guard.condition >= graph.nodes.size()) return "a guard names a node that does not exist";
    if (!is_number(graph, guard.condition)) return "a guard's condition is not a number";
    if (guard.location != no_location && guard.location >= graph.locations.size())
      return "a guard names a location that does not exist";
  }
  return {};
}

// Checks the per-node columns: locations, names, exactness.
std::string check_columns(Graph const &graph) {
  if (!graph.node_location.empty() && graph.node_location.size() != graph.nodes.size())
    return "the number of nodes' locations differs";
  for (LocationId location : graph.node_location)
    if (location != no_location && location >= graph.locations.size())
      return "a node names a location that does not exist";
  if (!graph.node_name.empty() && graph.node_name.size() != graph.nodes.size())
    return "the number of nodes' names differs";
  for (NameId name : graph.node_name)
    if (name != no_name && name >= graph.names.size()) return "a node has a name that does not exist";
  if (!graph.node_exact.empty() && graph.node_exact.size() != graph.nodes.size())
    return "the number of nodes that may be exact differs";
  return {};
}

} // namespace

bool is_range(Range const &range) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return range.low <= range.high && range.low < infinity && range.high > -infinity;
}

std::string find_violation(External const &external) {
  std::vector<std::string_view> names = {external.name};
  for (DerivativeFunction const &derivative : external.derivatives) names.push_back(derivative.name);
  for (std::string_view name : names)
    if (!is_c_identifier(name)) return "'" + std::string(name) + "' is not the name of a function in C";
  if (external.returned.is_pointer()) return "a function returns a number, an integer or an object";
  if (!external.derivatives.empty() && !external.pure) return "a function with effects has no derivative";
  if (std::string const violation = type_violation(external.returned); !violation.empty()) return violation;
  for (ExternalValue const &parameter : external.parameters)
    if (std::string const violation = type_violation(parameter); !violation.empty()) return violation;
  return math_violation(external);
}

std::string find_violation(Graph const &graph, NodeId *node) {
  for (auto const *objects : {&graph.inputs, &graph.parameters, &graph.outputs})
    if (std::string violation = check_objects(*objects); !violation.empty()) return violation;
  for (DerivativeMatrix const &matrix : graph.matrices)
    if (std::string violation = check_matrix(matrix, graph.outputs); !violation.empty()) return violation;
  for (Table const &table : graph.tables)
    if (std::string violation = check_table(table); !violation.empty()) return violation;
  if (std::string violation = check_externals(graph.externals); !violation.empty()) return violation;
  if (graph.results.size() != graph.output_count()) return "the number of results differs from the outputs' size";
  if (graph.input_values.size() != graph.input_count()) return "the number of input values differs";
  if (graph.parameter_values.size() != graph.parameter_count()) return "the number of parameter values differs";
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (char const *violation = find_node_violation(graph, static_cast<NodeId>(id))) {
      if (node) *node = static_cast<NodeId>(id);
      return "node " + std::to_string(id) + " " + violation;
    }
  for (auto const &check : {check_roots, check_effects, check_columns})
    if (std::string violation = check(graph); !violation.empty()) return violation;
  return {};
}

} // namespace symreal
