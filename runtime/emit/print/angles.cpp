#include "emit/print/angles.h"

#include "emit/print/module.h"

namespace symreal {

void print_angles(Emission const &emission, CodeText &out) {
  std::vector<std::uint32_t> const &inputs = emission.plan.angles.inputs;
  if (inputs.empty()) return;
  Language const &language = emission.language;
  AnglesSyntax const &syntax = language.angles;
  std::string const input(name_of(Array::input)), count = std::to_string(inputs.size());
  std::string const sine(name_of(Array::sine)), cosine(name_of(Array::cosine));
  std::string angles = input;
  if (inputs.back() - inputs.front() + 1 == inputs.size()) {
    if (inputs.front() != 0)
      angles = fill(language, syntax.from, {{"array", input}, {"first", std::to_string(inputs.front())}});
  } else {
    angles = "angle";
    std::vector<std::string> elements;
    for (std::uint32_t const slot : inputs) elements.push_back(element(language, input, slot));
    out.lines("  " + fill(language, syntax.begin, {{"name", angles}, {"count", count}}) + lines_of(language, elements) +
              std::string(syntax.end) + "\n");
  }
  for (std::string const &array : {sine, cosine})
    out.statement(2, fill(language, language.statements.array, {{"name", array}, {"count", count}}));
  out.statement(
      2, fill(language, syntax.call, {{"count", count}, {"angles", angles}, {"sine", sine}, {"cosine", cosine}}));
}

} // namespace symreal
