#include "engine/emit/print/loop_step.h"

#include "engine/emit/print/body.h"
#include "engine/emit/print/loop_indices.h"
#include "engine/emit/print/loop_tables.h"
#include "engine/emit/print/records.h"

#include <fmt/format.h>

namespace symreal {

namespace {

using reroll::Access;
using reroll::Leaf;
using reroll::Step;
using reroll::Store;

class StepPrinter {
public:
  StepPrinter(Emission &emission, Step const &step, StepNumbers const &numbers, LoopTables const &tables,
              LoopArrays const &arrays, CodeText &out, std::set<std::string> &used)
      : emission_(emission),
        language_(emission.language),
        step_(step),
        numbers_(numbers),
        tables_(tables),
        indices_(emission.language, step),
        names_(indices_.names()),
        arrays_(arrays),
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
    Schedule const plan = schedule(step_.body);
    Emission inner{plan, whole, emission_.options, nullptr, nullptr, names_};
    BodyPrinter printer(inner, plan.compute, true, arrays_.filled);
    printer.spell_inputs(leaves, constant_leaves());
    CodeText statements(language_);
    printer.statements(0, statements, indent_);
    out_.append(std::move(statements));
    for (std::size_t k = 0; k < stores.size(); ++k) set(stores[k], printer.use(step_.stores[k].value));
    for (std::size_t k = 0; k < leaves.size(); ++k)
      if (step_.leaves[k].kind == Leaf::Kind::carried) set(leaves[k], printer.use(step_.leaves[k].next));
    emission_.uses.add(inner.uses);
    indices_.end(out_);
  }

private:
  // Compilers may unroll a loop and see the values of a table.
  std::vector<char> constant_leaves() const {
    std::vector<char> constant;
    for (Leaf const &leaf : step_.leaves)
      constant.push_back(arrays_.may_be_constant && !reroll::is_argument(leaf.kind));
    return constant;
  }

  void find_records() {
    if (indices_.is_nested()) return;
    for (Leaf const &leaf : step_.leaves)
      if (leaf.kind == Leaf::Kind::memory || (indices_.is_loop() && leaf.kind != Leaf::Kind::values))
        records_.add(array_of(leaf.kind), leaf.access, false);
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
      leaves.push_back(step_.leaves[k].kind == Leaf::Kind::values ? indexed(rows_[walk], std::to_string(column))
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
    bool const is_carried = leaf.kind == Leaf::Kind::carried;
    std::string text = element(is_carried ? arrays_.memory : array_of(leaf.kind), leaf.access);
    bool const is_fixed = indices_.is_fixed(leaf.access), in_turn = indices_.is_fixed_in_turn(leaf.access);
    if (!is_carried && !is_fixed && !in_turn) return text;
    std::string name = (is_carried ? "c" : "f") + std::to_string(number);
    names_.insert(name);
    std::string declaration = fill(language_, is_carried ? syntax.variable : syntax.constant,
                                   {{"type", language_.number.name}, {"name", name}, {"value", text}});
    if (is_carried || is_fixed)
      out_.statement(2, declaration);
    else
      of_turn_.push_back(std::move(declaration));
    return name;
  }

  std::string const &array_of(Leaf::Kind kind) const {
    switch (kind) {
    case Leaf::Kind::given: return arrays_.given;
    case Leaf::Kind::read: return arrays_.read;
    case Leaf::Kind::sine: return arrays_.sine;
    case Leaf::Kind::cosine: return arrays_.cosine;
    default: return arrays_.memory;
    }
  }

  std::string const &array_of(Store const &store) const { return store.is_result ? arrays_.filled : arrays_.memory; }

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
  Step const &step_;
  StepNumbers const &numbers_;
  LoopTables const &tables_;
  LoopIndices indices_;
  std::set<std::string> names_; // names that the body must not use
  LoopArrays const &arrays_;
  CodeText &out_;
  std::set<std::string> &used_;
  std::vector<std::string> table_names_, rows_; // names, per walk through a table
  Records records_{indices_.is_loop()};
  std::vector<std::string> record_names_;
  std::vector<std::string> of_turn_; // statements of the outer loop
  std::size_t element_tables_ = 0, indent_ = 2;
};

} // namespace

void print_step(Emission &emission, reroll::Step const &step, StepNumbers const &numbers, LoopTables const &tables,
                LoopArrays const &arrays, CodeText &out, std::set<std::string> &used) {
  StepPrinter(emission, step, numbers, tables, arrays, out, used).print();
}

} // namespace symreal
