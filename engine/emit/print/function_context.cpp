#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/expression.h"
#include "engine/support/number.h"

namespace symreal {

FunctionContext::FunctionContext(Emission &emission, FunctionBody const &body, bool in_compute)
    : emission(emission),
      body(body),
      in_compute(in_compute),
      spelling(emission, body),
      variable(body.regions.value_count(), no_slot),
      kept(body.regions.value_count(), no_slot),
      element_(emission.language, emission.language.expressions.element, {"array", "index"}) {
  bool const hides = !emission.language.expressions.hidden.empty() && emission.options.mode != FloatingPoint::fast;
  if (hides) constant_paths = constant_on_a_path(graph());
}

void FunctionContext::append_element(std::string &text, std::string_view array, std::size_t index) {
  arrays.insert(array);
  std::string number; // short enough to avoid allocation
  append_number(number, index + emission.language.expressions.first_index);
  element_.append_to(text, {array, number});
}

std::string FunctionContext::result_element(NodeId call, std::size_t result) {
  if (kept[call] != no_slot) {
    std::string text;
    append_element(text, "v", kept[call] + result);
    return text;
  }
  return symreal::element(emission.language, "r" + std::to_string(variable[call]), result);
}

} // namespace symreal
