#include "emit/print/loops.h"

#include "emit/language/pattern.h"
#include "emit/print/angles.h"
#include "emit/print/constant_paths.h"
#include "emit/print/function_head.h"
#include "emit/print/loop_step.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal {

namespace {

using reroll::Step;
using reroll::Store;

class LoopsPrinter {
public:
  LoopsPrinter(Emission &emission, reroll::LoopFunction const &function, FunctionPlan const &plan)
      : emission_(emission),
        language_(emission.language),
        syntax_(emission.language.functions),
        function_(function),
        plan_(plan),
        arrays_{plan.inputs.front(),
                plan.inputs.back(),
                "v",
                plan.target,
                std::string(name_of(Array::sine)),
                std::string(name_of(Array::cosine)),
                hides_arguments(emission.graph())} {}

  CodeText print() {
    CodeText out(language_), last(language_);
    std::set<std::string> used = {arrays_.given, arrays_.read, arrays_.filled}; // the calls pass them on
    if (plan_.has_angles()) print_angles(emission_, last);
    last.statement(
        2, fill(language_, language_.statements.array,
                {{"name", arrays_.memory}, {"count", std::to_string(std::max<std::size_t>(function_.memory, 1))}}));
    bool is_checked = false;
    for (std::size_t k = 0; k < function_.steps.size(); ++k) {
      Step const &step = function_.steps[k];
      bool const fills = std::ranges::any_of(step.stores, &Store::is_result);
      if (fills && !std::exchange(is_checked, true)) print_checks(last);
      print_part(k, fills, out, last);
    }
    if (!is_checked) print_checks(last);
    if (!function_.checks.empty()) last.statement(2, syntax_.success);
    append(out, plan_.is_local ? syntax_.local_head : syntax_.head, !function_.checks.empty(), plan_.name, plan_.inputs,
           arrays_.filled, used, std::move(last));
    return out;
  }

private:
  void print_checks(CodeText &out) const {
    for (std::size_t k = 0; k < function_.checks.size(); ++k) {
      std::string const condition = emission_.spellings.apply(
          Op::eq, element(language_, arrays_.memory, function_.checks[k]), constant(language_, 0));
      out.statement(2, fill(language_, language_.statements.check,
                            {{"condition", condition}, {"number", std::to_string(k + 1)}}));
    }
  }

  // What fills the results reads memory alone.
  void print_part(std::size_t number, bool fills, CodeText &out, CodeText &calls) {
    CodeText text(language_);
    std::set<std::string> used = {arrays_.memory};
    print_step(emission_, function_.steps[number], arrays_, text, used);
    std::string const name = language_.names.spelled(fmt::format("{}_{}", plan_.name, number + 1));
    std::vector<std::string> inputs = {arrays_.memory};
    if (!fills) inputs = plan_.part_inputs;
    std::string const &last = fills ? arrays_.filled : arrays_.memory;
    append(out, syntax_.local_head, false, name, inputs, last, used, std::move(text));
    out.lines("\n");
    calls.statement(
        2, fill(language_, syntax_.call,
                {{"name", name}, {"group", ""}, {"arguments", fmt::format("{}, {}", fmt::join(inputs, ", "), last)}}));
  }

  // A parameter that the text does not use is marked, or compilers warn.
  void append(CodeText &out, std::string_view head, bool may_fail, std::string const &name,
              std::vector<std::string> const &inputs, std::string const &last, std::set<std::string> const &used,
              CodeText &&text) const {
    std::string parameters, unused;
    auto const add = [&](std::string_view pattern, std::string const &parameter) {
      parameters += (parameters.empty() ? "" : ", ") + fill(language_, pattern, {{"name", parameter}});
      if (!used.contains(parameter)) unused += "  " + fill(language_, syntax_.unused, {{"name", parameter}}) + "\n";
    };
    for (std::string const &input : inputs) add(syntax_.input, input);
    add(syntax_.output, last);
    out.statement(
        0, print_head(language_, head, {.name = name, .parameters = parameters, .target = last, .may_fail = may_fail}));
    out.lines(unused);
    out.append(std::move(text));
    out.statement(0, Filling().set_name("name", name)(with_words(language_, syntax_.end)));
  }

  Emission &emission_;
  Language const &language_;
  FunctionSyntax const &syntax_;
  reroll::LoopFunction const &function_;
  FunctionPlan const &plan_;
  LoopArrays arrays_;
};

} // namespace

CodeText print_loops(Emission &emission, reroll::LoopFunction const &function, FunctionPlan const &plan) {
  return LoopsPrinter(emission, function, plan).print();
}

} // namespace symreal
