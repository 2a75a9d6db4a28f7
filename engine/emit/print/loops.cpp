#include "engine/emit/print/body.h"
#include "engine/emit/print/constant_paths.h"
#include "engine/emit/print/function.h"
#include "engine/emit/print/loop_indices.h"
#include "engine/emit/print/number_tables.h"
#include "engine/plan/schedule/schedule.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ranges>

namespace symreal {

namespace {

using reroll::Access;
using reroll::Leaf;
using reroll::LoopStep;
using reroll::Store;

std::string spelled(Array array) { return array == Array::memory ? "v" : std::string(name_of(array)); }

// Prints one step into `out`, with the tables that only this step reads; adds the names of the arrays in the text to
// `used`.
class StepPrinter {
public:
  StepPrinter(Emission &emission, LoopStep const &step, StepNumbers const &numbers, LoopTables const &tables,
              std::string const &filled, bool may_be_constant, CodeText &out, std::set<std::string> &used)
      : emission_(emission),
        language_(emission.language),
        step_(step),
        numbers_(numbers),
        tables_(tables),
        indices_(emission.language, step),
        names_(indices_.names()),
        filled_(filled),
        may_be_constant_(may_be_constant),
        out_(out),
        used_(used) {}

  void print() {
    find_records();
    std::vector<std::string> const leaves = spell_leaves();
    std::vector<std::string> stores;
    for (Store const &store : step_.stores) stores.push_back(element(array_of(store), store.access, true));
    std::vector<std::string> const rows = spell_rows();
    indent_ = indices_.begin(of_turn_, out_);
    for (std::string const &row : rows) out_.statement(indent_, row);
    Language whole = language_; // the body is not cut
    whole.functions.most_statements = std::string::npos;
    Plan const plan = schedule(step_.body);
    Emission inner{plan, whole, emission_.options, names_};
    BodyPrinter printer(inner, plan.compute(), filled_);
    printer.spell_inputs(leaves, constant_leaves());
    CodeText statements(language_);
    printer.statements(0, statements, indent_);
    out_.append(std::move(statements));
    for (std::size_t k = 0; k < stores.size(); ++k) set(stores[k], printer.use(step_.stores[k].value));
    for (std::size_t k = 0; k < leaves.size(); ++k)
      if (step_.leaves[k].is_carried) set(leaves[k], printer.use(step_.leaves[k].next));
    emission_.uses.add(inner.uses);
    indices_.end(out_);
  }

private:
  // Compilers may unroll a loop and see the values of a table.
  std::vector<char> constant_leaves() const {
    std::vector<char> constant;
    for (Leaf const &leaf : step_.leaves) constant.push_back(may_be_constant_ && !is_argument(leaf.array));
    return constant;
  }

  void find_records() {
    if (indices_.is_nested()) return;
    for (Leaf const &leaf : step_.leaves)
      if ((leaf.array == Array::memory && !leaf.is_carried) || (indices_.is_loop() && leaf.array != Array::values))
        records_.add(spelled(leaf.array), leaf.access, false);
    for (Store const &store : step_.stores)
      if (!store.is_result || indices_.is_loop()) records_.add(array_of(store), store.access, true);
    records_.choose();
    std::size_t read = 0, stored = 0;
    for (Record const &record : records_.chosen())
      record_names_.push_back(own_name(record.is_stored ? fmt::format("w{}", ++stored) : fmt::format("r{}", ++read)));
  }

  std::vector<std::string> spell_leaves() {
    for (TableWalk const &walk : numbers_.walks) {
      NumberTable const &table = tables_.table(walk.table);
      std::string name = tables_.name(walk.table);
      if (!tables_.is_shared(walk.table)) {
        name = own_name(name);
        print_number_table(emission_, 2, name, table, out_);
      }
      names_.insert({name, rows_name(name)});
      table_names_.push_back(std::move(name));
      rows_.push_back(own_name(walk.by_turn ? "turn_row" : "row"));
    }
    std::vector<std::string> leaves;
    for (std::size_t k = 0; k < step_.leaves.size(); ++k) {
      auto const &[walk, column] = numbers_.places[k];
      leaves.push_back(step_.leaves[k].array == Array::values ? indexed(rows_[walk], std::to_string(column))
                                                              : spell(step_.leaves[k], k));
    }
    return leaves;
  }
  // A name that is unused in the step.
  std::string own_name(std::string const &wish) {
    std::string name = wish;
    for (std::size_t number = 2; !names_.insert(name).second; ++number) name = fmt::format("{}_{}", wish, number);
    return name;
  }

  // Invariant elements are read before the loop: compilers cannot know that no store changes them.
  std::string spell(Leaf const &leaf, std::size_t number) {
    StatementSyntax const &syntax = language_.statements;
    std::string text = element(spelled(leaf.array), leaf.access);
    bool const is_fixed = indices_.is_fixed(leaf.access), in_turn = indices_.is_fixed_in_turn(leaf.access);
    if (!leaf.is_carried && !is_fixed && !in_turn) return text;
    std::string name = (leaf.is_carried ? "c" : "f") + std::to_string(number);
    names_.insert(name);
    std::string declaration = fill(language_, leaf.is_carried ? syntax.variable : syntax.constant,
                                   {{"type", language_.number.name}, {"name", name}, {"value", text}});
    if (leaf.is_carried || is_fixed)
      out_.statement(2, declaration);
    else
      of_turn_.push_back(std::move(declaration));
    return name;
  }

  std::string array_of(Store const &store) const { return store.is_result ? filled_ : spelled(Array::memory); }

  std::string element(std::string const &array, Access const &access, bool is_stored = false) {
    used_.insert(array);
    if (std::optional<Records::Place> const place = records_.find(array, access, is_stored))
      return indexed(record_names_[place->record], std::to_string(place->element));
    std::optional<std::string> const index = indices_.of_element(access);
    return indexed(array, index ? *index : indexed(element_table(access.elements), indices_.of_iteration()));
  }
  std::string indexed(std::string_view array, std::string const &index) const {
    return fill(language_, language_.expressions.element, {{"array", array}, {"index", index}});
  }
  std::string element_table(std::vector<std::uint32_t> const &elements) {
    std::string name = own_name(fmt::format("table_{}", ++element_tables_));
    print_element_table(language_, 2, name, elements, out_);
    return name;
  }

  // Statements for the begins of records and table rows, in the body or in the outer loop.
  std::vector<std::string> spell_rows() {
    std::vector<std::string> statements;
    for (std::size_t k = 0; k < record_names_.size(); ++k) {
      Record const &record = records_.chosen()[k];
      std::string const index = index_text(record.first, {{record.step, indices_.of_iteration()}});
      statements.push_back(fill(language_, record.is_stored ? language_.loops.stored_row : language_.loops.row,
                                {{"name", record_names_[k]}, {"table", record.array}, {"index", index}}));
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      TableWalk const &walk = numbers_.walks[k];
      std::string const count = walk.by_turn ? indices_.of_turn() : indices_.of_iteration();
      std::string const index = begin_of_row(language_, walk, tables_.table(walk.table), table_names_[k], count);
      (walk.by_turn ? of_turn_ : statements)
          .push_back(
              fill(language_, language_.loops.row, {{"name", rows_[k]}, {"table", table_names_[k]}, {"index", index}}));
    }
    return statements;
  }

  void set(std::string const &name, std::string const &value) {
    out_.statement(indent_, fill(language_, language_.statements.set, {{"name", name}, {"value", value}}));
  }

  Emission &emission_;
  Language const &language_;
  LoopStep const &step_;
  StepNumbers const &numbers_;
  LoopTables const &tables_;
  LoopIndices indices_;
  std::set<std::string> names_; // names that the body must not use
  std::string const &filled_;   // array for the results
  bool may_be_constant_;        // whether memory is constant on some path
  CodeText &out_;
  std::set<std::string> &used_;
  std::vector<std::string> table_names_, rows_; // names, per walk through a table
  Records records_{indices_.is_loop()};
  std::vector<std::string> record_names_;
  std::vector<std::string> of_turn_; // statements of the outer loop
  std::size_t element_tables_ = 0, indent_ = 2;
};

class LoopsPrinter {
public:
  LoopsPrinter(Emission &emission, PlanFunction const &function, FunctionNames const &names)
      : emission_(emission),
        language_(emission.language),
        syntax_(emission.language.functions),
        kind_(info(function.kind)),
        function_(*function.loops),
        names_(names),
        tables_(emission.language, names.name, function_.steps),
        may_be_constant_(hides_arguments(emission.graph())) {}

  CodeText print() {
    CodeText out(language_), last(language_);
    std::set<std::string> used;
    tables_.print_shared(emission_, out);
    if (names_.has_angles()) {
      print_angles(emission_, last);
      used.insert(spelled(Array::input));
      if (emission_.plan.angles.computed != 0) used.insert(spelled(Array::constants));
    }
    if (function_.memory != 0)
      last.statement(2, fill(language_, language_.statements.array,
                             {{"name", spelled(Array::memory)}, {"count", std::to_string(function_.memory)}}));
    bool is_checked = false;
    for (std::size_t k = 0; k < function_.steps.size(); ++k) {
      LoopStep const &step = function_.steps[k];
      bool const fills = std::ranges::any_of(step.stores, &Store::is_result);
      if (fills && !std::exchange(is_checked, true)) print_checks(last);
      used.merge(print_part(k, out, last));
    }
    if (!is_checked) print_checks(last);
    for (reroll::Mirror const &mirror : function_.mirrors) print_mirror(mirror, last);
    if (!function_.checks.empty()) last.statement(2, syntax_.success);
    std::vector<Parameter> parameters;
    for (std::string const &input : names_.inputs) parameters.push_back({syntax_.input, input, used.contains(input)});
    parameters.push_back({syntax_.output, names_.target, used.contains(names_.target)});
    append_function(language_, kind_.is_helper ? syntax_.local_head : syntax_.head,
                    {.name = names_.name, .target = names_.target, .may_fail = !function_.checks.empty()}, parameters,
                    std::move(last), out);
    return out;
  }

private:
  void print_checks(CodeText &out) const {
    for (std::size_t k = 0; k < function_.checks.size(); ++k) {
      std::string const condition = emission_.spellings.apply(
          Op::eq, element(language_, spelled(Array::memory), function_.checks[k]), constant(language_, 0));
      out.statement(2, fill(language_, language_.statements.check,
                            {{"condition", condition}, {"number", std::to_string(k + 1)}}));
    }
  }

  void print_mirror(reroll::Mirror const &mirror, CodeText &out) const {
    auto const element = [&](char const *row, char const *column) {
      return fill(language_, language_.expressions.element,
                  {{"array", names_.target}, {"index", index_text(mirror.first, {{mirror.rows, row}, {1, column}})}});
    };
    std::string const below = element("row", "column"), above = element("column", "row");
    std::string const copy =
        fill(language_, language_.statements.set,
             {{"name", mirror.from_above ? below : above}, {"value", mirror.from_above ? above : below}});
    out.lines(fill(language_, language_.loops.below_diagonal, {{"rows", std::to_string(mirror.rows)}, {"copy", copy}}));
  }

  // Prints a part, and returns the arrays that it uses, its parameters. Arrays that it fills overlap no other.
  std::set<std::string> print_part(std::size_t number, CodeText &out, CodeText &calls) {
    LoopStep const &step = function_.steps[number];
    CodeText text(language_);
    std::set<std::string> used;
    StepPrinter(emission_, step, tables_.of_step(number), tables_, names_.target, may_be_constant_, text, used).print();
    std::vector<Parameter> parameters;
    for (std::string const &input : names_.part_inputs)
      if (used.contains(input)) parameters.push_back({syntax_.input, input});
    bool const stores = !std::ranges::all_of(step.stores, &Store::is_result);
    if (used.contains(spelled(Array::memory)))
      parameters.push_back({stores ? syntax_.local_output : syntax_.input, spelled(Array::memory)});
    if (used.contains(names_.target)) parameters.push_back({syntax_.local_output, names_.target});
    std::string const name = language_.names.spelled(fmt::format("{}_{}", names_.name, number + 1));
    FunctionHead const head{.name = name,
                            .target = parameters.back().name,
                            .is_side_by_side = emission_.forbids_fusion() && reroll::is_side_by_side(step)};
    emission_.uses.side_by_side |= head.is_side_by_side;
    append_function(language_, syntax_.local_head, head, parameters, std::move(text), out);
    out.lines("\n");
    std::string const arguments =
        fmt::format("{}", fmt::join(parameters | std::views::transform(&Parameter::name), ", "));
    calls.statement(2, fill(language_, syntax_.call, {{"name", name}, {"group", ""}, {"arguments", arguments}}));
    return used;
  }

  Emission &emission_;
  Language const &language_;
  FunctionSyntax const &syntax_;
  FunctionInfo const &kind_;
  reroll::LoopFunction const &function_;
  FunctionNames const &names_;
  LoopTables tables_;
  bool may_be_constant_;
};

} // namespace

CodeText print_loops(Emission &emission, PlanFunction const &function, FunctionNames const &names) {
  return LoopsPrinter(emission, function, names).print();
}

} // namespace symreal
