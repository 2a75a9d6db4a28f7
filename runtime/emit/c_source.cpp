#include "emit/c_parts.h"
#include "emit/expression.h"
#include "emit/trace.h"
#include "emit/value_checks.h"
#include "schedule/chunks.h"

#include <algorithm>
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

namespace {

bool is_truth(Node const &node) { return !is_leaf(node.op) && info(node.op).has(flag::BOOLEAN); }

// One of the two functions, printed chunk by chunk: a long one becomes static functions that the last one calls.
class FunctionPrinter {
public:
  FunctionPrinter(Program const &program, EmitOptions const &options, bool is_compute)
      : program_(program),
        body_(is_compute ? program.compute : program.preprocess),
        is_compute_(is_compute),
        name_(prefixed(options, is_compute ? "compute" : "preprocess")),
        options_(options),
        chunks_(cut(program, body_, is_compute)),
        spelling_(program, body_),
        variable_(program.graph->nodes.size(), no_slot),
        kept_(program.graph->nodes.size(), no_slot) {}

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
      std::size_t const check = check_;
      std::string const text = statements(chunk);
      bool const checks = check_ != check;
      out += function((checks ? "static int " : "static void ") + name, "v", text + (checks ? end : "")) + "\n";
      calls += checks ? fmt::format("  failed = {};\n  if (failed != 0) return failed;\n", call)
                      : fmt::format("  {};\n", call);
    }
    return out + function(head, target(), calls + results() + end);
  }

  bool has_value_checks() const {
    return options_.check_values && std::any_of(body_.variables.begin(), body_.variables.end(),
                                                [this](NodeId id) { return !is_truth(program_.graph->nodes[id]); });
  }

private:
  std::string checks_begin() const { return has_value_checks() ? value_check_begin() : ""; }
  std::string target() const { return is_compute_ ? "output" : "constants"; }

  std::string statements(std::size_t chunk) {
    std::string out;
    std::vector<NodeId> spelled_out;
    FunctionContext const context{is_compute_, &variable_, &spelling_, &kept_, &spelled_out};
    std::size_t const first = chunks_.begin[chunk], end = chunks_.begin[chunk + 1];
    for (std::size_t k = first; k < end; ++k) {
      append_checks(out, context, chunk, k);
      NodeId const id = body_.variables[k];
      Node const &node = program_.graph->nodes[id];
      bool const truth = is_truth(node);
      std::string const name = spelling_(k);
      spelled_out.clear();
      std::string const value = c_expression(program_, context, id);
      append_wrapped(out, fmt::format("{} const {} = {};", truth ? "int" : "double", name, value) +
                              trace_marker(*program_.graph, spelled_out));
      if (options_.check_values && !truth) out += value_check(*program_.graph, name, id);
      variable_[id] = static_cast<std::uint32_t>(k);
      if (chunks_.spill_slot[id] != no_slot) out += fmt::format("  v[{}] = {};\n", chunks_.spill_slot[id], name);
    }
    append_checks(out, context, chunk, end);
    if (chunks_.size() == 1) return out;
    for (std::size_t k = first; k < end; ++k) { // what this chunk has in a variable, later ones find in v
      variable_[body_.variables[k]] = no_slot;
      kept_[body_.variables[k]] = chunks_.spill_slot[body_.variables[k]];
    }
    return out;
  }

  // Those that stand before statement k, in its chunk.
  void append_checks(std::string &out, FunctionContext const &context, std::size_t chunk, std::size_t k) {
    for (; check_ < body_.checks.size(); ++check_) {
      Check const &check = body_.checks[check_];
      if (check.before != k || chunks_.of_check(check) != chunk) return;
      append_wrapped(out, fmt::format("if ({}) return {};", c_failure(program_, context, check.condition), check_ + 1));
    }
  }

  std::string results() {
    std::string out;
    FunctionContext const context{is_compute_, &variable_, &spelling_, &kept_};
    for (std::size_t slot = 0; slot < body_.results.size(); ++slot)
      append_wrapped(out, fmt::format("{}[{}] = {};", target(), slot, c_use(program_, context, body_.results[slot])));
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

  Program const &program_;
  FunctionBody const &body_;
  bool is_compute_;
  std::string name_;
  EmitOptions const &options_;
  Chunks chunks_;
  VariableNames spelling_;
  std::vector<std::uint32_t> variable_, kept_;
  std::size_t check_ = 0; // the next to be printed
};

} // namespace

std::string c_source(Program const &program, EmitOptions const &options) {
  FunctionPrinter preprocess(program, options, false), compute(program, options, true);
  bool const checked = preprocess.has_value_checks() || compute.has_value_checks();
  std::string text = c_banner(program, options) +
                     fmt::format("#include \"{}.h\"\n\n#include <math.h>\n{}\n", options.base_name,
                                 checked ? value_check_helper() : "") +
                     preprocess.print() + "\n" + compute.print();
  if (!program.graph->guards.empty()) text += "\n" + c_guard_text(program, options);
  return text;
}

} // namespace symreal
