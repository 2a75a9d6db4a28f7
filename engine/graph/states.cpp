#include "engine/graph/states.h"

#include <algorithm>

namespace symreal {

// Finds an object by its label, or by its name: "x[0:2]" or x.
static std::size_t find(std::vector<Object> const &objects, std::string const &name) {
  auto const is_meant = [&](Object const &object) {
    return object.label == name || object.label.substr(0, object.label.find('[')) == name;
  };
  return static_cast<std::size_t>(std::ranges::find_if(objects, is_meant) - objects.begin());
}

std::vector<State> find_states(Graph const &graph) {
  std::vector<State> states;
  for (StatePair const &pair : graph.states) {
    auto const require = [&](bool holds, std::string const &why) {
      if (!holds)
        fail(DiagnosticId::pragma_syntax, pair.place, "state(" + pair.state + ", " + pair.derivative + "): " + why);
    };
    State const state{find(graph.inputs, pair.state), find(graph.outputs, pair.derivative)};
    require(state.input != graph.inputs.size(), "'" + pair.state + "' is no input of kernel '" + graph.kernel + "'");
    require(state.output != graph.outputs.size(),
            "'" + pair.derivative + "' is no output of kernel '" + graph.kernel + "'");
    Object const &input = graph.inputs[state.input], &output = graph.outputs[state.output];
    require(input.extents == output.extents && input.members == output.members, "they have different shapes");
    for (State const &other : states)
      require(other.input != state.input && other.output != state.output, "another state(...) names one of them");
    states.push_back(state);
  }
  std::ranges::sort(states, {}, &State::input);
  return states;
}

} // namespace symreal
