#include "program/wrapper_text.h"

#include "diagnostics/diagnostic.h"

#include <algorithm>
#include <fmt/format.h>

namespace symreal::program {
namespace {

// Loops over the elements of an object, around a statement on `element` (an lvalue in the words of the source) and
// `slot` (of the flat array).
template <class Statement>
std::string for_elements(rewrite::Annotation const &annotation, Object const &object, Statement const &statement) {
  std::string loops, element = "(" + annotation.expression + ")", slot;
  std::string indent = "  ";
  for (std::size_t dimension = 0; dimension < object.extents.size(); ++dimension) {
    std::string index = fmt::format("symreal_{}", dimension);
    loops += fmt::format("{0}for (int {1} = 0; {1} < {2}; ++{1})\n", indent, index, object.extents[dimension]);
    indent += "  ";
    bool section = dimension < annotation.sections.size();
    element += section ? fmt::format("[({}) + {}]", annotation.sections[dimension].low, index) : "[" + index + "]";
    slot = slot.empty() ? index : fmt::format("({}) * {} + {}", slot, object.extents[dimension], index);
  }
  slot = slot.empty() ? std::to_string(object.first) : fmt::format("{} + {}", object.first, slot);
  return fmt::format("{}{}{}\n", loops, indent, statement(element, slot));
}

// In the order of the graph, which may differ from that of the pragma: a returned value comes first.
rewrite::Annotation const &annotation_of(rewrite::Kernel const &kernel, std::string_view kind, Object const &object) {
  auto found = std::find_if(kernel.annotations.begin(), kernel.annotations.end(), [&](auto const &annotation) {
    return annotation.kind == kind && annotation.label == object.label;
  });
  internal_check(found != kernel.annotations.end());
  return *found;
}

} // namespace

std::string wrapper_arrays(Graph const &graph) {
  auto const array = [](std::string_view name, std::size_t count) {
    return fmt::format("  double symreal_{}[{}];\n", name, std::max<std::size_t>(count, 1));
  };
  return array("input", graph.input_count()) + array("parameters", graph.parameter_count()) +
         array("constants", graph.precomputed.size()) + array("output", graph.output_count());
}

std::string wrapper_pack(rewrite::Kernel const &kernel, std::string_view kind, std::vector<Object> const &objects,
                         std::string_view array) {
  std::string text;
  for (Object const &object : objects)
    text += for_elements(annotation_of(kernel, kind, object), object, [array](auto const &element, auto const &slot) {
      return fmt::format("{}[{}] = {};", array, slot, element);
    });
  return text;
}

std::string wrapper_unpack(rewrite::Kernel const &kernel, std::vector<Object> const &objects,
                           ReturnStatement const &returned) {
  std::string text, last;
  for (Object const &object : objects) {
    rewrite::Annotation const &annotation = annotation_of(kernel, "output", object);
    if (annotation.expression == "return")
      last = "  " + returned(annotation, fmt::format("symreal_output[{}]", object.first)) + "\n";
    else
      text += for_elements(annotation, object, [](auto const &element, auto const &slot) {
        return fmt::format("{} = symreal_output[{}];", element, slot);
      });
  }
  return text + last;
}

} // namespace symreal::program
