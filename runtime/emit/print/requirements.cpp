#include "emit/print/requirements.h"

namespace symreal {

static bool has_live(Graph const &graph, bool (*test)(Op)) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !is_leaf(graph.nodes[id].op) && test(graph.nodes[id].op)) return true;
  return false;
}

void require_expressible(Graph const &graph, Language const &language, EmitOptions const &options) {
  auto const require = [&](bool is_there, bool is_wanted, std::string const &what) {
    if (is_wanted && !is_there)
      fail(DiagnosticId::bad_option, {}, what + ", which --lang=" + std::string(language.name) + " does not have");
  };
  std::string const kernel = "kernel '" + graph.kernel + "' needs ";
  require(language.externals.call, has_live(graph, is_call), kernel + "external functions");
  require(!language.tables.begin.empty(), has_live(graph, [](Op op) { return op == Op::lookup || op == Op::lookup2; }),
          kernel + "tables");
  require(language.files.integer_functions,
          has_live(graph, [](Op op) { return info(op).form == Form::local || is_wide(op); }),
          kernel + "integers of 64 bits");
  require(!language.statements.check.empty(), !graph.guards.empty(), kernel + "guards");
  require(!language.statements.value_check.empty(), options.check_values, "--check-values needs reports of values");
  require(language.files.mainline.text, options.mainline, "--mainline needs a main program");
}

} // namespace symreal
