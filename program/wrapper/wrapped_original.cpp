#include "program/wrapper/wrapped_original.h"

#include "program/wrapper/baked_values.h"
#include "program/wrapper/wrapper_text.h"
#include "program/wrapper/wrapper_variations.h"
#include "rewrite/text/pragma_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>

namespace symreal::program {
namespace {

// Joins the lines, so that line numbers stay.
std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string squeezed(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
  return text;
}

std::string packing(Recorded const &recorded) {
  return wrapper_pack(recorded.kernel, "input", recorded.graph.inputs, "symreal_input") +
         wrapper_pack(recorded.kernel, "parameter", recorded.graph.parameters, "symreal_parameters");
}

std::string checks(Recorded const &recorded) {
  std::string text = baked_checks(recorded, Otherwise::remember);
  for (ExtentCheck const &one : wrapper_extents(recorded.kernel, recorded.graph))
    text += fmt::format("if ({}) symreal_same = 0; ", one.differs);
  return text;
}

// Statements that apply the chosen variation. `member`: where in the function.
std::string variations(std::vector<Variation> const &all, std::string Variation::*member) {
  if (all.empty()) return "int const symreal_varied = 0; ";
  std::string text = "char const *const symreal_wish = symreal_environment(\"SYMREAL_VARY\"); "
                     "int const symreal_varied = symreal_wish ? symreal_integer(symreal_wish) : 0; ";
  for (std::size_t k = 0; k < all.size(); ++k)
    if (std::string const &statement = all[k].*member; !statement.empty())
      text += fmt::format("if (symreal_varied == {0} || symreal_varied == -{0}) {{ {1} }} ", k + 1, statement);
  return text;
}

// Statements at the function's begin.
std::string statements_before(Recorded const &recorded) {
  std::vector<Variation> const all = wrapper_variations(recorded);
  bool const any = std::ranges::any_of(all, [](Variation const &one) { return !one.before.empty(); });
  return any ? "{ " + variations(all, &Variation::before) + "} " : "";
}

std::string statements(Recorded const &recorded) {
  bool returns = false;
  std::string const unpacking = wrapper_unpack(recorded.kernel, recorded.graph.outputs, [&](std::string const &value) {
    returns = true;
    return "return " + recorded.kernel.signature.redefinition.result.begin + ", " + value + ");";
  });
  return fmt::format("if (SYMREAL_ORIGINAL_IS_ACTIVE) {{ {} if (symreal_varied >= 0) {{ int symreal_same = 1; {} "
                     "if (symreal_same) {{ {} {} if (symreal_original_compute(symreal_input, {}, symreal_output) == 0) "
                     "{{ {} {} }} }} }} }}",
                     variations(wrapper_variations(recorded), &Variation::statement), checks(recorded),
                     wrapper_arrays(recorded.graph), packing(recorded),
                     recorded.graph.parameter_count() == 0 ? "0" : "symreal_parameters", unpacking,
                     returns ? "" : "return;");
}

constexpr char const *library = "char *symreal_environment(char const *) __asm__(\"getenv\"); "
                                "int symreal_integer(char const *) __asm__(\"atoi\"); ";

} // namespace

void insert_in_wrapper_place(rewrite::Result &annotated, rewrite::Kernel const &kernel, std::string const &statements,
                             std::string const &top, bool with_classes, std::string const &before) {
  std::string const place = rewrite::place_arguments(kernel.name, kernel.place),
                    mark = "SYMREAL_ORIGINAL_WRAPPER(" + place + ")";
  bool is_found = false;
  for (rewrite::File &file : annotated.files)
    if (std::size_t const at = file.text.find(mark); at != file.text.npos) {
      file.text.replace(at, mark.size(), on_one_line(statements));
      std::size_t const begin = file.text.rfind("SYMREAL_ORIGINAL_FUNCTION(" + place, at);
      internal_check(begin != file.text.npos);
      file.text.insert(begin, on_one_line(before));
      file.text.insert(0, (with_classes ? "#include <typeinfo>\n" : "") + on_one_line(top) + "\n#line 1\n");
      is_found = true;
    }
  internal_check(is_found);
}

bool is_wrapper_of(std::string const &text, Recorded const &recorded) {
  std::string const unpacking = wrapper_unpack(recorded.kernel, recorded.graph.outputs,
                                               [](std::string const &value) { return "return " + value + ";"; });
  std::string const all = squeezed(text);
  auto const has = [&](std::string const &part) { return all.find(squeezed(part)) != all.npos; };
  return has(packing(recorded)) && has(unpacking) &&
         (has(baked_checks(recorded, Otherwise::remember)) || has(baked_checks(recorded, Otherwise::refuse)));
}

std::string build_wrapped(Front const &front, Recorded const &recorded) {
  rewrite::Result wrapped = front.annotated;
  bool const is_cxx = !is_c(recorded.kernel);
  std::string top = (is_cxx ? "extern \"C\" { " : "") + std::string(library) + (is_cxx ? "} " : "");
  for (std::string const &block : baked_helpers(recorded)) top += block;
  for (std::string const &block : wrapper_templates(recorded.kernel, recorded.graph)) top += block;
  top += variation_helpers(recorded);
  insert_in_wrapper_place(wrapped, recorded.kernel, statements(recorded), top, compares_classes(recorded),
                          statements_before(recorded));
  Overlay const text(wrapped, front.workspace->directory("annotated-wrapper"));
  constexpr std::array variants = {Variant::wrapped};
  return build_variants(front.build, variants, *front.overlay, text, *front.workspace).front();
}

} // namespace symreal::program
