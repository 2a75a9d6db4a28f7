#include "engine/emit/print/loops.h"

#include "engine/emit/language/pattern.h"
#include "engine/emit/print/angles.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/function_head.h"
#include "engine/emit/print/loop_indices.h"
#include "engine/emit/print/loop_step.h"
#include "engine/plan/reroll/side_by_side.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ranges>

namespace symreal {

namespace {

using reroll::Step;
using reroll::Store;

struct Parameter {
  std::string_view pattern;
  std::string name;
};

class LoopsPrinter {
public:
  LoopsPrinter(Emission &emission, reroll::LoopFunction const &function, FunctionPlan const &plan)
      : emission_(emission),
        language_(emission.language),
        syntax_(emission.language.functions),
        function_(function),
        plan_(plan),
        tables_(emission.language, plan.name, function.steps),
        arrays_{plan.inputs.front(),
                plan.inputs.back(),
                "v",
                plan.target,
                std::string(name_of(Array::sine)),
                std::string(name_of(Array::cosine)),
                hides_arguments(emission.graph())} {}

  CodeText print() {
    CodeText out(language_), last(language_);
    std::set<std::string> used;
    tables_.print_shared(emission_, out);
    if (plan_.has_angles()) {
      print_angles(emission_, last);
      used.insert(arrays_.given);
      if (!emission_.plan.angles.computed.results.empty()) used.insert(arrays_.read);
    }
    if (function_.memory != 0)
      last.statement(2, fill(language_, language_.statements.array,
                             {{"name", arrays_.memory}, {"count", std::to_string(function_.memory)}}));
    bool is_checked = false;
    for (std::size_t k = 0; k < function_.steps.size(); ++k) {
      Step const &step = function_.steps[k];
      bool const fills = std::ranges::any_of(step.stores, &Store::is_result);
      if (fills && !std::exchange(is_checked, true)) print_checks(last);
      used.merge(print_part(k, out, last));
    }
    if (!is_checked) print_checks(last);
    for (reroll::Mirror const &mirror : function_.mirrors) print_mirror(mirror, last);
    if (!function_.checks.empty()) last.statement(2, syntax_.success);
    std::vector<Parameter> parameters;
    for (std::string const &input : plan_.inputs) parameters.push_back({syntax_.input, input});
    parameters.push_back({syntax_.output, arrays_.filled});
    FunctionHead const head{.name = plan_.name, .may_fail = !function_.checks.empty()};
    append(out, plan_.is_local ? syntax_.local_head : syntax_.head, head, parameters, used, std::move(last));
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

  void print_mirror(reroll::Mirror const &mirror, CodeText &out) const {
    auto const element = [&](char const *row, char const *column) {
      return fill(language_, language_.expressions.element,
                  {{"array", arrays_.filled}, {"index", index_text(mirror.first, {{mirror.rows, row}, {1, column}})}});
    };
    std::string const below = element("row", "column"), above = element("column", "row");
    std::string const copy =
        fill(language_, language_.statements.set,
             {{"name", mirror.from_above ? below : above}, {"value", mirror.from_above ? above : below}});
    out.lines(fill(language_, language_.loops.below_diagonal, {{"rows", std::to_string(mirror.rows)}, {"copy", copy}}));
  }

  // Prints a part, and returns the arrays that it uses, its parameters. Arrays that it fills overlap no other.
  std::set<std::string> print_part(std::size_t number, CodeText &out, CodeText &calls) {
    Step const &step = function_.steps[number];
    CodeText text(language_);
    std::set<std::string> used;
    print_step(emission_, step, tables_.of_step(number), tables_, arrays_, text, used);
    std::vector<Parameter> parameters;
    for (std::string const &input : plan_.part_inputs)
      if (used.contains(input)) parameters.push_back({syntax_.input, input});
    bool const stores = !std::ranges::all_of(step.stores, &Store::is_result);
    if (used.contains(arrays_.memory))
      parameters.push_back({stores ? syntax_.local_output : syntax_.input, arrays_.memory});
    if (used.contains(arrays_.filled)) parameters.push_back({syntax_.local_output, arrays_.filled});
    std::string const name = language_.names.spelled(fmt::format("{}_{}", plan_.name, number + 1));
    FunctionHead const head{.name = name,
                            .is_side_by_side = emission_.forbids_fusion() && reroll::is_side_by_side(step)};
    emission_.uses.side_by_side |= head.is_side_by_side;
    append(out, syntax_.local_head, head, parameters, used, std::move(text));
    out.lines("\n");
    std::string const arguments =
        fmt::format("{}", fmt::join(parameters | std::views::transform(&Parameter::name), ", "));
    calls.statement(2, fill(language_, syntax_.call, {{"name", name}, {"group", ""}, {"arguments", arguments}}));
    return used;
  }

  // Marks parameters that the text does not use, against compiler warnings.
  void append(CodeText &out, std::string_view pattern, FunctionHead head, std::vector<Parameter> const &parameters,
              std::set<std::string> const &used, CodeText &&text) const {
    std::vector<std::string> words;
    std::string unused;
    for (Parameter const &parameter : parameters) {
      words.push_back(fill(language_, parameter.pattern, {{"name", parameter.name}}));
      if (!used.contains(parameter.name))
        unused += "  " + fill(language_, syntax_.unused, {{"name", parameter.name}}) + "\n";
    }
    head.parameters = fmt::format("{}", fmt::join(words, ", "));
    head.target = parameters.back().name;
    out.statement(0, print_head(language_, pattern, head));
    out.lines(unused);
    out.append(std::move(text));
    out.statement(0, Filling().set_name("name", head.name)(with_words(language_, syntax_.end)));
  }

  Emission &emission_;
  Language const &language_;
  FunctionSyntax const &syntax_;
  reroll::LoopFunction const &function_;
  FunctionPlan const &plan_;
  LoopTables tables_;
  LoopArrays arrays_;
};

} // namespace

CodeText print_loops(Emission &emission, reroll::LoopFunction const &function, FunctionPlan const &plan) {
  return LoopsPrinter(emission, function, plan).print();
}

} // namespace symreal
