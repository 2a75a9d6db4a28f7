// Results of the calls in a graph, each call evaluated once.
#pragma once

#include "engine/graph/evaluate.h"
#include "engine/graph/opaque.h"

#include <map>
#include <utility>
#include <vector>

namespace symreal {

class CallResults {
public:
  // `graph` and `call` must outlive this object. `call` may be empty if the graph calls complex functions only.
  CallResults(Graph const &graph, CallExternal const &call) : graph_(graph), call_(call) {}

  // Results of function number `function` for the arguments of node `call`, whose values `value_of(node)` gives.
  template <class ValueOf> std::vector<double> &of(NodeId call, std::size_t function, ValueOf const &value_of) {
    auto const [found, is_new] = results_.try_emplace({call, function});
    if (is_new) found->second = results(call, function, value_of);
    return found->second;
  }

private:
  template <class ValueOf>
  std::vector<double> results(NodeId call, std::size_t function, ValueOf const &value_of) const {
    std::vector<double> arguments;
    for (NodeId const argument : arguments_of(graph_, graph_.nodes[call].operand[0]))
      arguments.push_back(value_of(argument));
    return called(function, arguments);
  }
  std::vector<double> called(std::size_t function, std::vector<double> const &arguments) const;

  Graph const &graph_;
  CallExternal const &call_;
  std::map<std::pair<NodeId, std::size_t>, std::vector<double>> results_;
};

} // namespace symreal
