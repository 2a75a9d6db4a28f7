#include "verify/next_call.h"

#include "program/wrapper/wrapper_text.h"
#include "runtime/replay/compare.h"

#include <algorithm>
#include <cctype>

namespace symreal::program {
namespace {

std::vector<std::string> words_of(std::string const &text) {
  std::vector<std::string> words(1);
  for (char const one : text)
    if (std::isalnum(static_cast<unsigned char>(one)) != 0 || one == '_')
      words.back() += one;
    else if (!words.back().empty())
      words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

// Name of each parameter, or the last word of its declaration if it is unnamed or its declarator encloses the name.
std::vector<std::string> parameters_of(rewrite::Kernel const &kernel) {
  std::string const &text = kernel.signature.declaration;
  std::size_t begin = text.find(kernel.name + "(");
  std::vector<std::string> names;
  if (begin == text.npos) return {""};
  begin += kernel.name.size() + 1;
  std::size_t depth = 0, first = begin;
  for (std::size_t at = begin; at < text.size(); ++at) {
    char const one = text[at];
    bool const ends = depth == 0 && (one == ',' || one == ')');
    if (ends) {
      std::size_t const last = std::min(text.find_first_of("[=", first), at);
      std::vector<std::string> const words = words_of(text.substr(first, last - first));
      bool const is_none = words.empty() || (words.size() == 1 && words[0] == "void");
      if (!is_none) names.push_back(words.back());
      first = at + 1;
    }
    if (ends && one == ')') return names;
    if (one == '(' || one == '<' || one == '[') ++depth;
    if (depth != 0 && (one == ')' || one == '>' || one == ']')) --depth;
  }
  return {""};
}

constexpr unsigned seconds = 2; // time limit of a sample

} // namespace

bool is_next_call_comparable(Recorded const &recorded) {
  rewrite::Kernel const &kernel = recorded.kernel;
  rewrite::Redefinition const &function = kernel.signature.redefinition;
  if (!kernel.is_function || function.has_this || !recorded.graph.frozen.empty()) return false;
  // Other shapes may have the same number of elements.
  if (!wrapper_containers(kernel, recorded.graph).empty()) return false;
  std::vector<std::string> named;
  auto const add = [&named](std::string const &text) {
    for (std::string &word : words_of(text)) named.push_back(std::move(word));
  };
  for (rewrite::Annotation const &one : kernel.annotations) {
    if (one.kind == "constant" || one.sections.size() > 1) return false;
    add(one.expression);
    for (rewrite::Section const &section : one.sections) add(section.low + " " + section.length);
  }
  auto const is_output = [&](std::string const &label) {
    return std::ranges::any_of(kernel.annotations,
                               [&](auto const &one) { return one.kind == "output" && one.label == label; });
  };
  bool const may_meet = std::ranges::any_of(
      function.overlaps, [&](rewrite::Overlap const &one) { return is_output(one.first) && is_output(one.second); });
  return !may_meet && std::ranges::all_of(parameters_of(kernel), [&](std::string const &one) {
    return std::ranges::find(named, one) != named.end();
  });
}

std::size_t different_in_next_call(Front const &front, RunOptions const &run, Recorded const &recorded,
                                   GeneratedCode &code, Replay &first, std::string const &executable,
                                   std::vector<Sample> const &samples, double tolerance) {
  std::size_t different = 0;
  try {
    Replay next("the original in its next call", executable, run, recorded.begun_as, recorded.graph, *front.workspace,
                nullptr, {}, {"SYMREAL_LATER_CALL=1"});
    for (Sample const &sample : samples) {
      std::vector<double> const original = next.run(sample, {}, seconds);
      (void)first.run(sample, {}, seconds);
      std::vector<double> const nothing(original.size(), 0);
      if (first.next_inputs(sample, nothing) != next.next_inputs(sample, nothing)) return 0;
      std::vector<double> const generated = code.run(sample.inputs, sample.parameters).outputs;
      different += !std::ranges::equal(original, generated,
                                       [&](double a, double b) { return same(a, b, code.banner().mode, tolerance); });
    }
  } catch (DiagnosticError const &) {
    return 0;
  }
  return different;
}

} // namespace symreal::program
