#include "engine/emit/print/requirements.h"

#include "engine/emit/print/bridges.h"
#include "engine/graph/complex_function.h"
#include "engine/graph/names.h"
#include "engine/graph/opaque.h"

#include <algorithm>

namespace symreal {

template <class Test> static bool has_live(Graph const &graph, Test const &test) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id)
    if (live[id] && !is_leaf(graph.nodes[id].op) && test(graph.nodes[id].op)) return true;
  return false;
}

// A file whose name is an identifier in its contents needs a valid one.
static void require_file_name(Language const &language, EmitOptions const &options) {
  bool const names_it = std::ranges::any_of(language.files.companions, [&](Companion const &file) {
    return file.is_named_after_file && options.extras.contains(file.option);
  });
  if (!names_it && !language.module.is_named_after_file) return;
  if (identifier(options.base_name, language.names) == options.base_name) return;
  fail(DiagnosticId::bad_option, {},
       "a file of --lang=" + std::string(language.name) + " is called as what it contains, and '" + options.base_name +
           "' is no name there: give another with -o");
}

// Requirements of calls on bridges.
template <class Require> static void require_bridges(Graph const &graph, BridgeSyntax const &syntax,
                                                     std::string const &kernel, Require const &require) {
  std::vector<char> const live = live_nodes(graph);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!live[id] || !is_call(graph.nodes[id].op)) continue;
    External const &external = graph.externals[function_of(graph, graph.nodes[id])];
    require(false, find_complex_function(external).has_value(), kernel + "functions of complex numbers");
    auto const look = [&](ExternalValue const &value) {
      require(find_integer(syntax, value.type), value.kind == ExternalValue::Kind::integer,
              kernel + "'" + external.name + "', which has an integer of type '" + value.type + "'");
    };
    look(external.returned);
    for (ExternalValue const &parameter : external.parameters) look(parameter);
  }
}

void require_expressible(Schedule const &plan, Language const &language, EmitOptions const &options) {
  Graph const &graph = *plan.graph;
  auto const require = [&](bool is_there, bool is_wanted, std::string const &what) {
    if (is_wanted && !is_there)
      fail(DiagnosticId::bad_option, {}, what + ", which --lang=" + std::string(language.name) + " does not have");
  };
  require_file_name(language, options);
  std::string const kernel = "kernel '" + graph.kernel + "' needs ";
  bool const calls = has_live(graph, is_call);
  require(language.externals.is_given(), calls, kernel + "external functions");
  if (calls && language.externals.bridge.is_given()) require_bridges(graph, language.externals.bridge, kernel, require);
  require(!language.tables.begin.empty(), has_live(graph, [](Op op) { return op == Op::lookup || op == Op::lookup2; }),
          kernel + "tables");
  bool const has_integers = language.files.integer_functions || !language.files.helpers.empty();
  require(has_integers, has_live(graph, [](Op op) { return info(op).form == Form::local || is_wide(op); }),
          kernel + "integers of 64 bits");
  for (Op const op : language.lacks)
    require(false, has_live(graph, [&](Op other) { return other == op; }),
            kernel + "operation " + std::string(info(op).name));
  require(!language.statements.check.empty(), !graph.guards.empty(), kernel + "guards");
  require(!language.statements.value_check.empty(), options.check_values, "--check-values needs reports of values");
  require(language.parallel.is_given(), plan.threads > 1, "--parallel needs OpenMP sections");
  for (std::string const &extra : options.extras) {
    bool const is_there =
        std::ranges::any_of(language.files.companions, [&](Companion const &file) { return file.option == extra; });
    require(is_there, true, "--" + extra + " needs a file of its own");
  }
}

} // namespace symreal
