#include "emit/print/constant_paths.h"
#include "emit/print/expression.h"

namespace symreal {

FunctionContext::FunctionContext(Emission &emission, FunctionBody const &body, bool in_compute)
    : emission(emission),
      body(body),
      in_compute(in_compute),
      spelling(emission, body),
      variable(body.regions.value_count(), no_slot),
      kept(body.regions.value_count(), no_slot) {
  bool const hides = !emission.language.expressions.hidden.empty() && emission.options.mode != FloatingPoint::fast;
  if (hides) constant_paths = constant_on_a_path(graph());
}

std::string FunctionContext::element(std::string_view array, std::size_t index) {
  arrays.insert(array);
  return symreal::element(emission.language, array, index);
}

std::string FunctionContext::result_element(NodeId call, std::size_t result) {
  if (kept[call] != no_slot) return element("v", kept[call] + result);
  return symreal::element(emission.language, "r" + std::to_string(variable[call]), result);
}

} // namespace symreal
