#include "emit/c_parts.h"
#include "emit/expression.h"

#include <fmt/format.h>

namespace symreal {

// Breaks a statement at blanks so that lines stay readable; the text has no string literals.
static void append_wrapped(std::string &out, std::string_view statement) {
  constexpr std::size_t width = 100;
  std::size_t indent = 2;
  while (true) {
    out.append(indent, ' ');
    if (statement.size() + indent <= width) break;
    std::size_t cut = statement.rfind(' ', width - indent);
    if (cut == std::string_view::npos || cut == 0) cut = statement.find(' ');
    if (cut == std::string_view::npos) break;
    out.append(statement.substr(0, cut)) += '\n';
    statement.remove_prefix(cut + 1);
    indent = 6;
  }
  out.append(statement) += '\n';
}

static bool reads(Program const &program, FunctionBody const &body, bool in_compute, bool of_constants) {
  auto is_wanted = [&](NodeId id) {
    Node const &node = program.graph->nodes[id];
    bool is_constant_slot = in_compute && program.constant_slot[id] != no_slot;
    return of_constants ? is_constant_slot : !is_constant_slot && (node.op == Op::input || node.op == Op::parameter);
  };
  // Every node that is read stands below a variable or is a result; nested expressions are walked by an own stack.
  std::vector<NodeId> stack(body.results);
  std::vector<char> seen(program.graph->nodes.size(), 0);
  while (!stack.empty()) {
    NodeId id = stack.back();
    stack.pop_back();
    if (seen[id]++) continue;
    if (is_wanted(id)) return true;
    if (is_leaf(program.graph->nodes[id].op) || (in_compute && program.constant_slot[id] != no_slot)) continue;
    for (NodeId operand : program.graph->nodes[id].operand)
      if (operand != no_node) stack.push_back(operand);
  }
  return false;
}

static std::string body(Program const &program, FunctionBody const &body, bool in_compute, std::string const &target) {
  std::string out;
  std::vector<std::uint32_t> name(program.graph->nodes.size(), no_slot);
  FunctionContext const context{in_compute, &name};
  std::uint32_t next = 0;
  for (NodeId id : body.variables) {
    Node const &node = program.graph->nodes[id];
    bool truth = !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN);
    std::string value = c_expression(program, context, id);
    append_wrapped(out, fmt::format("{} const t{} = {};", truth ? "int" : "double", next, value));
    name[id] = next++;
  }
  for (std::size_t slot = 0; slot < body.results.size(); ++slot)
    append_wrapped(out, fmt::format("{}[{}] = {};", target, slot, c_use(program, context, body.results[slot])));
  return out;
}

std::string c_source(Program const &program, EmitOptions const &options) {
  std::string out = c_banner(program, options);
  out += fmt::format("#include \"{}.h\"\n\n#include <math.h>\n\n", options.base_name);

  out += fmt::format("void {}(double const *parameters, double *constants) {{\n", prefixed(options, "preprocess"));
  if (!reads(program, program.preprocess, false, false)) out += "  (void)parameters;\n";
  if (program.preprocess.results.empty()) out += "  (void)constants;\n";
  out += body(program, program.preprocess, false, "constants") + "}\n\n";

  out += fmt::format("void {}(double const *input, double const *constants, double *output) {{\n",
                     prefixed(options, "compute"));
  if (!reads(program, program.compute, true, false)) out += "  (void)input;\n";
  if (!reads(program, program.compute, true, true)) out += "  (void)constants;\n";
  if (program.compute.results.empty()) out += "  (void)output;\n";
  out += body(program, program.compute, true, "output") + "}\n";
  return out;
}

} // namespace symreal
