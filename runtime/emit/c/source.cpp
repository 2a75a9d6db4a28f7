#include "emit/c/externals.h"
#include "emit/c/parts.h"
#include "emit/origins/origins.h"
#include "emit/origins/value_checks.h"
#include "emit/print/constant_paths.h"
#include "emit/print/expression.h"
#include "emit/print/integers.h"
#include "graph/complex_function.h"
#include "graph/opaque.h"
#include "schedule/blocks.h"
#include "schedule/order.h"
#include "support/number.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal {

// Breaks a statement at blanks so that lines stay readable; the text has no string literals.
static void append_wrapped(std::string &out, std::size_t indent, std::string_view statement) {
  std::size_t const width = std::max<std::size_t>(100, indent + 60), first_indent = indent;
  while (true) {
    out.append(indent, ' ');
    if (statement.size() + indent <= width) break;
    std::size_t cut = statement.rfind(' ', width - indent);
    if (cut == std::string_view::npos || cut == 0) cut = statement.find(' ');
    if (cut == std::string_view::npos) break;
    out.append(statement.substr(0, cut)) += '\n';
    statement.remove_prefix(cut + 1);
    indent = first_indent + 4;
  }
  out.append(statement) += '\n';
}

namespace {

// One of the two functions, printed chunk by chunk: a long one becomes static functions that the last one calls.
class FunctionPrinter {
public:
  FunctionPrinter(Schedule const &plan, EmitOptions const &options, bool is_compute)
      : plan_(plan),
        body_(is_compute ? plan.compute : plan.preprocess),
        is_compute_(is_compute),
        name_(prefixed(options, is_compute ? "compute" : "preprocess")),
        options_(options),
        chunks_(cut(plan, body_, is_compute)),
        spelling_(plan, body_),
        variable_(body_.regions.value_count(), no_slot),
        kept_(body_.regions.value_count(), no_slot) {
    if (options.mode != FloatingPoint::fast) constant_paths_ = constant_on_a_path(*plan.graph);
  }

  std::string print() {
    bool const may_fail = !body_.checks.empty();
    std::string const end = may_fail ? "  return 0;\n" : "", head = (may_fail ? "int " : "void ") + name_;
    if (chunks_.size() == 1) {
      std::string text = statements(0);
      return function(head, target(), checks_begin() + text + results() + end);
    }
    std::string out, calls = fmt::format("  double v[{}];\n", chunks_.spill_count) + checks_begin();
    if (may_fail) calls += "  int failed = 0;\n";
    for (std::size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
      std::string const name = fmt::format("{}_{}", name_, chunk + 1);
      std::string const call = fmt::format("{}({}, v)", name, is_compute_ ? "input, constants" : "parameters");
      std::size_t const printed_before = checks_printed_;
      std::string const text = statements(chunk);
      bool const checks = checks_printed_ != printed_before;
      out += function((checks ? "static int " : "static void ") + name, "v", text + (checks ? end : "")) + "\n";
      calls += checks ? fmt::format("  failed = {};\n  if (failed != 0) return failed;\n", call)
                      : fmt::format("  {};\n", call);
    }
    return out + function(head, target(), calls + results() + end);
  }

  bool has_value_checks() const {
    for (std::size_t k = 0; options_.check_values && k < body_.variables.size(); ++k)
      if (is_number(k) && !is_call_node(plan_, body_, body_.variables[k])) return true;
    return false;
  }

private:
  std::string checks_begin() const { return has_value_checks() ? value_check_begin() : ""; }
  std::string target() const { return is_compute_ ? "output" : "constants"; }

  std::string statements(std::size_t chunk) {
    std::string out;
    std::size_t indent = 2;
    std::vector<Step> const steps = blocks(plan_, body_, is_compute_, chunks_, chunk);
    for (std::size_t k = chunks_.begin[chunk]; k < chunks_.begin[chunk + 1]; ++k) {
      NodeId const id = body_.variables[k];
      variable_[id] = static_cast<std::uint32_t>(k);
      if (is_call_node(plan_, body_, id)) kept_[id] = chunks_.spill_slot[id]; // its results go there at once
    }
    for (Step const &step : steps) {
      if (step.kind == Step::Kind::close || step.kind == Step::Kind::otherwise) indent -= 2;
      if (is_about_variable(step) && is_call_node(plan_, body_, body_.variables[step.index])) {
        append_call(out, indent, step);
        continue;
      }
      append_wrapped(out, indent, text(step));
      bool const sets = step.kind == Step::Kind::set || step.kind == Step::Kind::set_const;
      if (sets && options_.check_values && is_number(step.index))
        out += std::string(indent - 2, ' ') +
               value_check(*plan_.graph, spelling_(step.index), body_.variables[step.index]);
      if (step.kind == Step::Kind::open || step.kind == Step::Kind::otherwise) indent += 2;
    }
    if (chunks_.size() == 1) return out;
    for (std::size_t k = chunks_.begin[chunk]; k < chunks_.begin[chunk + 1]; ++k) {
      variable_[body_.variables[k]] = no_slot; // what this chunk has in a variable, later ones find in v
      kept_[body_.variables[k]] = chunks_.spill_slot[body_.variables[k]];
    }
    return out;
  }

  FunctionContext context(std::vector<NodeId> *spelled_out = nullptr) const {
    return {is_compute_, &variable_,  &spelling_,
            &kept_,      spelled_out, constant_paths_.empty() ? nullptr : &constant_paths_};
  }

  static bool is_about_variable(Step const &step) {
    return step.kind == Step::Kind::declare || step.kind == Step::Kind::set || step.kind == Step::Kind::set_const ||
           step.kind == Step::Kind::keep;
  }

  // A call, with an array for its results: its own, or where later chunks find them.
  void append_call(std::string &out, std::size_t indent, Step const &step) {
    Graph const &graph = *plan_.graph;
    NodeId const id = body_.variables[step.index];
    External const &external = graph.externals[function_of(graph, graph.nodes[id])];
    bool const is_wanted = body_.wanted_returns.contains(id), is_kept = chunks_.spill_slot[id] != no_slot;
    bool const has_array = !is_kept && external.result_count() > (is_wanted ? 0 : external.returned_count());
    ResultArray const results =
        is_kept ? ResultArray{"v", chunks_.spill_slot[id]} : ResultArray{"r" + std::to_string(step.index), 0};
    std::string const array = fmt::format("double {}[{}]", results.name, external.result_count());
    if (step.kind == Step::Kind::declare && has_array) append_wrapped(out, indent, array + " = {0.0};");
    if (step.kind == Step::Kind::declare || step.kind == Step::Kind::keep) return;
    if (step.kind == Step::Kind::set_const && has_array) append_wrapped(out, indent, array + ";");
    std::vector<NodeId> spelled_out = {id};
    FunctionContext const context = this->context(&spelled_out);
    std::vector<NodeId> const values = arguments_of(graph, graph.nodes[id].operand[0]);
    bool const is_folded = context.constant_paths && find_complex_function(external);
    NodeId const hidden = is_folded ? hidden_argument(graph, constant_paths_, values) : no_node;
    std::vector<std::string> arguments;
    for (NodeId value : values) {
      bool const is_integer = graph.nodes[value].is_constant() && external.takes_integer(arguments.size());
      std::string const use = is_integer ? shortest(graph.nodes[value].value()) : c_use(plan_, context, value);
      arguments.push_back(value == hidden ? fmt::format("{}({})", hide, use) : use);
    }
    std::vector<std::string> lines = c_call(external, std::to_string(step.index), arguments, results, is_wanted);
    lines.back() += trace_marker(graph, spelled_out);
    for (std::string const &line : lines) append_wrapped(out, indent, line);
  }

  std::string text(Step const &step) {
    FunctionContext const context = this->context();
    switch (step.kind) {
    case Step::Kind::declare:
      return fmt::format("{} {} = {};", type(step.index), spelling_(step.index), is_number(step.index) ? "0.0" : "0");
    case Step::Kind::open: return fmt::format("if ({}) {{", c_condition(plan_, context, step.literal));
    case Step::Kind::otherwise: return "} else {";
    case Step::Kind::close: return "}";
    case Step::Kind::set: return setting(step.index);
    case Step::Kind::set_const: return std::string(type(step.index)) + " const " + setting(step.index);
    case Step::Kind::keep:
      return kept(fmt::format("v[{}]", chunks_.spill_slot[body_.variables[step.index]]), body_.variables[step.index],
                  spelling_(step.index));
    case Step::Kind::check:
      ++checks_printed_;
      return fmt::format("if ({}) return {};", c_condition(plan_, context, {body_.checks[step.index].condition, false}),
                         step.index + 1);
    }
    return {};
  }

  std::string setting(std::size_t statement) const {
    NodeId const id = body_.variables[statement];
    std::vector<NodeId> spelled_out;
    FunctionContext const context = this->context(&spelled_out);
    std::string const value = body_.regions.is_gate(id) ? gate(context, id) : c_expression(plan_, context, id);
    return fmt::format("{} = {};", spelling_(statement), value) + trace_marker(*plan_.graph, spelled_out);
  }

  // One of the alternatives holds: all literals of one of them.
  std::string gate(FunctionContext const &context, NodeId id) const {
    auto in_parentheses = [](std::string const &text) { return text.find(' ') == text.npos ? text : "(" + text + ")"; };
    std::string any;
    for (RegionId alternative : body_.regions.alternatives(id)) {
      std::string all;
      for (Literal const &literal : body_.regions.literals(alternative))
        all += (all.empty() ? "" : " && ") + in_parentheses(c_condition(plan_, context, literal));
      if (all.empty()) return "1";
      any += (any.empty() ? "" : " || ") + in_parentheses(all);
    }
    return any.empty() ? "1" : any;
  }

  bool is_truth(std::size_t statement) const {
    NodeId const id = body_.variables[statement];
    if (body_.regions.is_gate(id)) return true;
    Op const op = plan_.graph->nodes[id].op;
    return !is_leaf(op) && info(op).has(flag::BOOLEAN);
  }
  bool is_wide_integer(NodeId id) const { return !body_.regions.is_gate(id) && is_wide(plan_.graph->nodes[id].op); }
  bool is_number(std::size_t statement) const {
    return !is_truth(statement) && !is_wide_integer(body_.variables[statement]);
  }
  char const *type(std::size_t statement) const {
    if (is_wide_integer(body_.variables[statement])) return "uint64_t";
    return is_truth(statement) ? "int" : "double";
  }

  std::string kept(std::string const &element, NodeId id, std::string const &value) const {
    return is_wide_integer(id) ? c_keep_integer(element, value) : fmt::format("{} = {};", element, value);
  }

  std::string results() {
    std::string out;
    FunctionContext const context = this->context();
    for (std::size_t slot = 0; slot < body_.results.size(); ++slot)
      append_wrapped(
          out, 2,
          kept(fmt::format("{}[{}]", target(), slot), body_.results[slot], c_use(plan_, context, body_.results[slot])));
    return out;
  }

  // A parameter that the text does not use is marked, or compilers warn.
  std::string function(std::string const &head, std::string const &last, std::string const &text) const {
    std::string unused;
    std::string parameters;
    for (std::string const &name :
         is_compute_ ? std::vector<std::string>{"input", "constants"} : std::vector<std::string>{"parameters"}) {
      parameters += "double const *" + name + ", ";
      bool const used = text.find(name + "[") != text.npos || text.find(name + ",") != text.npos;
      if (!used) unused += "  (void)" + name + ";\n";
    }
    if (text.find(last + "[") == std::string::npos) unused += "  (void)" + last + ";\n";
    return head + "(" + parameters + "double *" + last + ") {\n" + unused + text + "}\n";
  }

  Schedule const &plan_;
  FunctionBody const &body_;
  bool is_compute_;
  std::string name_;
  EmitOptions const &options_;
  Chunks chunks_;
  VariableNames spelling_;
  std::vector<std::uint32_t> variable_, kept_;
  std::vector<char> constant_paths_; // empty in mode fast
  std::size_t checks_printed_ = 0;
};

// Multiplications and additions are not to be fused, whatever the flags: gcc's vectoriser of straight-line code does it
// even with -ffp-contract=off, where sums and differences alternate.
constexpr char const *no_fusion = "#if defined(__clang__)\n"
                                  "#pragma STDC FP_CONTRACT OFF\n"
                                  "#elif defined(__GNUC__)\n"
                                  "#pragma GCC optimize(\"fp-contract=off\", \"no-tree-slp-vectorize\")\n"
                                  "#endif\n";

} // namespace

std::string c_source(Schedule const &plan, EmitOptions const &options) {
  FunctionPrinter preprocess(plan, options, false), compute(plan, options, true);
  bool const checked = preprocess.has_value_checks() || compute.has_value_checks();
  std::string const functions = preprocess.print() + "\n" + compute.print();
  std::string text = c_banner(plan, options) +
                     fmt::format("#include \"{}.h\"\n\n#include <math.h>\n{}{}{}\n", options.base_name,
                                 c_integer_includes(*plan.graph), checked ? value_check_helper() : "",
                                 options.mode == FloatingPoint::fast ? "" : no_fusion) +
                     c_declarations(*plan.graph) + c_integer_functions(functions) +
                     (functions.find(std::string(hide) + "(") == functions.npos ? "" : hide_definition) + functions;
  if (!plan.graph->guards.empty()) text += "\n" + c_guard_text(plan, options);
  return text;
}

} // namespace symreal
