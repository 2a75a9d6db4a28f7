#include "program/wrapped_original.h"

#include "program/wrapper_text.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace symreal::program {
namespace {

// Lines stay where they are.
std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string packing(Recorded const &recorded) {
  return wrapper_pack(recorded.kernel, "input", recorded.graph.inputs, "symreal_input") +
         wrapper_pack(recorded.kernel, "parameter", recorded.graph.parameters, "symreal_parameters");
}

std::string statements(Recorded const &recorded) {
  bool returns = false;
  std::string const unpacking = wrapper_unpack(
      recorded.kernel, recorded.graph.outputs, [&](rewrite::Annotation const &annotation, std::string const &value) {
        returns = true;
        return "return SYMREAL_RETURN(" + rewrite::place_arguments(annotation.label, annotation.place) + ", " + value +
               ");";
      });
  std::string text = fmt::format("if (SYMREAL_ORIGINAL_IS_ACTIVE) {{ {}{} if (symreal_original_compute(symreal_input, "
                                 "{}, symreal_output) == 0) {{ {} {} }} }}",
                                 wrapper_arrays(recorded.graph), packing(recorded),
                                 recorded.graph.parameter_count() == 0 ? "0" : "symreal_parameters", unpacking,
                                 returns ? "" : "return;");
  return on_one_line(std::move(text));
}

} // namespace

bool is_wrapper_of(std::string const &text, Recorded const &recorded) {
  std::string const unpacking =
      wrapper_unpack(recorded.kernel, recorded.graph.outputs,
                     [](rewrite::Annotation const &, std::string const &value) { return "return " + value + ";"; });
  return text.find(packing(recorded)) != text.npos && text.find(unpacking) != text.npos;
}

std::string build_wrapped(Front const &front, Recorded const &recorded) {
  std::string const mark =
      "SYMREAL_ORIGINAL_WRAPPER(" + rewrite::place_arguments(recorded.kernel.name, recorded.kernel.place) + ")";
  rewrite::Result wrapped = front.annotated;
  bool is_found = false;
  for (rewrite::File &file : wrapped.files)
    if (std::size_t const at = file.text.find(mark); at != file.text.npos) {
      file.text.replace(at, mark.size(), statements(recorded));
      std::string const templates = wrapper_templates(recorded.kernel, recorded.graph);
      if (!templates.empty()) file.text.insert(0, on_one_line(templates) + "\n#line 1\n");
      is_found = true;
    }
  internal_check(is_found);
  Overlay const text(wrapped, front.workspace->directory("annotated-wrapper"));
  constexpr std::array variants = {Variant::wrapped};
  return build_variants(front.build, variants, *front.overlay, text, *front.workspace).front();
}

} // namespace symreal::program
