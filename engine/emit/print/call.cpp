#include "engine/emit/print/call.h"

#include "engine/emit/print/bridges.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/graph/complex_function.h"
#include "engine/graph/opaque.h"
#include "engine/support/number.h"

namespace symreal {

CallStatement::CallStatement(FunctionContext &context, std::size_t statement)
    : context_(context),
      statement_(statement),
      call_(context.body.variables[statement]),
      number_(function_of(context.graph(), context.graph().nodes[call_])),
      function_(context.graph().externals[number_]),
      is_wanted_(context.body.wanted_returns.contains(call_)) {}

bool CallStatement::has_array() const {
  if (context_.emission.language.externals.bridge.is_given()) return !is_kept(); // a bridge stores all results
  return !is_kept() && function_.result_count() > (is_wanted_ ? 0 : function_.returned_count());
}

std::vector<std::string> CallStatement::print() const {
  Graph const &graph = context_.graph();
  Uses &uses = context_.emission.uses;
  uses.externals.insert(number_);
  if (is_kept()) context_.arrays.insert("v");
  std::vector<NodeId> const values = arguments_of(graph, graph.nodes[call_].operand[0]);
  bool const is_folded = !context_.constant_paths.empty() && find_complex_function(function_);
  NodeId const hidden = is_folded ? hidden_argument(graph, context_.constant_paths, values) : no_node;
  Language const &language = context_.emission.language;
  bool const has_bridge = language.externals.bridge.is_given(); // bridges take numbers only
  ExternalCall call{function_, std::to_string(statement_),           {},
                    array(),   is_kept() ? context_.kept[call_] : 0, is_wanted_};
  for (NodeId value : values) {
    bool const is_integer =
        !has_bridge && graph.nodes[value].is_constant() && function_.takes_integer(call.arguments.size());
    std::string const use = is_integer ? shortest(graph.nodes[value].value()) : print_argument(context_, value);
    uses.hidden = uses.hidden || value == hidden;
    call.arguments.push_back(value == hidden ? fill(language, language.expressions.hidden, {{"x", use}}) : use);
  }
  if (has_bridge) return {bridge_call(context_.emission, number_, call)};
  return language.externals.call(call);
}

} // namespace symreal
