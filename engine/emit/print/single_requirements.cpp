#include "engine/emit/print/single_requirements.h"

#include "engine/support/number.h"

#include <algorithm>
#include <cmath>

namespace symreal {

namespace {

constexpr std::string_view way_out = "; generate it with --real=double";

[[noreturn]] void refuse(std::string const &what) { fail(DiagnosticId::bad_option, {}, what + std::string(way_out)); }

bool overflows(double value) { return std::isfinite(value) && std::isinf(static_cast<float>(value)); }

void require_in_range(std::string const &of, std::span<double const> values) {
  auto const found = std::ranges::find_if(values, overflows);
  if (found != values.end()) refuse(of + " " + shortest(*found) + ", and a float ends at 3.4e38");
}

// Whether the operation needs integers beyond the 24 bits of a float: of 64 bits, and those that wrap at 32.
bool is_beyond(Op op) {
  return info(op).has(flag::WIDE | flag::TAKES_WIDE) || op == Op::mul_uint32 || op == Op::wrap_int32 ||
         op == Op::wrap_uint32;
}

void require_operations(std::string const &kernel, Graph const &graph) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    Node const &node = graph.nodes[id];
    if (!live[id]) continue;
    if (node.is_constant()) {
      double const value = node.value();
      require_in_range(kernel + "computes with", {&value, 1});
    }
    if (is_leaf(node.op)) continue;
    if (is_call(node.op)) refuse(kernel + "calls a function that takes doubles");
    if (is_beyond(node.op))
      refuse(kernel + "computes with integers of 32 bits that wrap, or of 64 (" + std::string(info(node.op).name) +
             "), and a float holds 24");
  }
}

} // namespace

void require_single(Graph const &graph, Language const &language, EmitOptions const &options) {
  if (language.single.number.name.empty())
    fail(DiagnosticId::bad_option, {},
         "--real=float needs single precision, which --lang=" + std::string(language.name) + " does not have");
  for (Companion const &companion : language.files.companions)
    if (companion.takes_doubles && options.extras.contains(companion.option))
      fail(DiagnosticId::bad_option, {},
           "--" + std::string(companion.option) + " hands on doubles: leave --real=float out");
  std::string const kernel = "kernel '" + graph.kernel + "' ";
  require_operations(kernel, graph);
  for (Table const &table : graph.tables) require_in_range(kernel + "has a table with", table.values);
  if (!options.extras.contains("mainline")) return; // only a main program has the recorded values
  require_in_range(kernel + "was recorded with the input", graph.input_values);
  require_in_range(kernel + "was recorded with the parameter", graph.parameter_values);
}

} // namespace symreal
