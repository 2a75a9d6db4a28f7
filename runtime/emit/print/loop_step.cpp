#include "emit/print/loop_step.h"

#include "emit/print/body.h"
#include "emit/print/module.h"
#include "emit/print/value_rows.h"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace symreal {

namespace {

using reroll::Access;
using reroll::Leaf;
using reroll::Step;
using reroll::Store;

constexpr std::string_view counter = "k";

class StepPrinter {
public:
  StepPrinter(Emission &emission, Step const &step, LoopArrays const &arrays, CodeText &out,
              std::set<std::string> &used)
      : emission_(emission),
        language_(emission.language),
        step_(step),
        arrays_(arrays),
        out_(out),
        used_(used) {}

  void print() {
    std::vector<std::string> const leaves = spell_leaves();
    for (auto &[period, rows] : values_) print_values(period, rows);
    begin_loop();
    Language whole = language_; // the body is not cut
    whole.functions.most_statements = std::string::npos;
    Schedule const plan = schedule(step_.body);
    Emission inner{plan, whole, emission_.options, nullptr, nullptr, names_};
    BodyPrinter printer(inner, plan.compute, true, arrays_.filled);
    printer.spell_inputs(leaves, constant_leaves());
    CodeText statements(language_);
    printer.statements(0, statements, indent_);
    out_.append(std::move(statements));
    for (Store const &store : step_.stores)
      set(element(store.is_result ? arrays_.filled : arrays_.memory, store.access), printer.use(store.value));
    for (std::size_t k = 0; k < leaves.size(); ++k)
      if (step_.leaves[k].kind == Leaf::Kind::carried) set(leaves[k], printer.use(step_.leaves[k].next));
    emission_.uses.add(inner.uses);
    if (is_loop()) out_.statement(2, language_.loops.end);
  }

private:
  bool is_loop() const { return step_.count > 1; }

  // Compilers may unroll a loop and see what a table holds.
  std::vector<char> constant_leaves() const {
    std::vector<char> constant;
    for (Leaf const &leaf : step_.leaves)
      constant.push_back(arrays_.may_be_constant && leaf.kind != Leaf::Kind::given && leaf.kind != Leaf::Kind::read);
    return constant;
  }

  std::vector<std::string> spell_leaves() {
    std::vector<std::size_t> column; // of a leaf in its table
    for (Leaf const &leaf : step_.leaves) {
      std::vector<std::vector<double> const *> *const columns =
          leaf.kind == Leaf::Kind::values ? &values_[leaf.values.size()].columns : nullptr;
      column.push_back(columns ? columns->size() : 0);
      if (columns) columns->push_back(&leaf.values);
    }
    std::vector<std::string> leaves;
    for (std::size_t k = 0; k < step_.leaves.size(); ++k)
      leaves.push_back(step_.leaves[k].kind == Leaf::Kind::values ? value(step_.leaves[k].values.size(), column[k])
                                                                  : spell(step_.leaves[k], k));
    return leaves;
  }

  std::string spell(Leaf const &leaf, std::size_t number) {
    StatementSyntax const &syntax = language_.statements;
    auto const declare = [&](char const *prefix, std::string_view pattern, std::string const &value) {
      std::string name = prefix + std::to_string(number);
      names_.insert(name);
      out_.statement(2, fill(language_, pattern, {{"type", language_.number.name}, {"name", name}, {"value", value}}));
      return name;
    };
    if (leaf.kind == Leaf::Kind::carried) return declare("c", syntax.variable, element(arrays_.memory, leaf.access));
    std::string const text = element(array_of(leaf.kind), leaf.access);
    bool const is_fixed = is_loop() && !leaf.access.is_listed() && leaf.access.step == 0;
    return is_fixed ? declare("f", syntax.constant, text) : text; // compilers cannot know that no store changes it
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

  std::string element(std::string const &array, Access const &access) {
    used_.insert(array);
    return indexed(array, access.is_listed() ? indexed(element_table(access.elements), std::string(counter))
                                             : place(access.first, access.step));
  }
  std::string indexed(std::string_view array, std::string const &index) const {
    return fill(language_, language_.expressions.element, {{"array", array}, {"index", index}});
  }
  // first + step * k
  static std::string place(std::int64_t first, std::int64_t step) {
    if (step == 0) return std::to_string(first);
    std::string const steps =
        std::abs(step) == 1 ? std::string(counter) : fmt::format("{}*{}", std::abs(step), counter);
    if (step < 0) return fmt::format("{} - {}", first, steps);
    return first == 0 ? steps : fmt::format("{} + {}", steps, first);
  }

  std::string element_table(std::vector<std::uint32_t> const &elements) {
    std::string const name = fmt::format("table_{}", ++element_tables_);
    print_element_table(name, elements);
    return name;
  }

  void print_element_table(std::string const &name, std::vector<std::uint32_t> const &elements) {
    std::vector<std::string> words;
    for (std::uint32_t element : elements) words.push_back(std::to_string(element));
    print_table(language_.loops.element_table, language_.loops.table_end, name, words);
  }

  // Values of one period stand in one table, those of an iteration in a row.
  std::string value(std::size_t period, std::size_t column) const {
    return indexed(row_name(period), std::to_string(column));
  }
  static std::string values_name(std::size_t period) { return fmt::format("values_{}", period); }
  static std::string row_name(std::size_t period) { return fmt::format("row_{}", period); }
  static std::string rows_name(std::size_t period) { return fmt::format("rows_{}", period); }

  void print_values(std::size_t period, ValueRows &rows) {
    write_once(rows);
    std::vector<std::string> words;
    for (std::uint32_t const row : rows.written)
      for (auto const *column : rows.columns) {
        words.push_back(constant(language_, (*column)[row]));
        emission_.uses.not_finite = emission_.uses.not_finite || !std::isfinite((*column)[row]);
      }
    print_table(language_.tables.begin, language_.tables.end, values_name(period), words);
    if (rows.is_listed()) print_element_table(rows_name(period), rows.which);
  }

  void print_table(std::string_view begin, std::string_view end, std::string const &name,
                   std::vector<std::string> const &words) {
    names_.insert(name);
    std::string const count = std::to_string(words.size());
    out_.lines("  " + fill(language_, begin, {{"name", name}, {"count", count}}) + lines_of(language_, words) +
               fill(language_, end, {{"name", name}, {"count", count}}) + "\n");
  }

  void begin_loop() {
    if (!is_loop()) return;
    names_.insert(std::string(counter));
    out_.statement(
        2, fill(language_, language_.loops.begin, {{"index", counter}, {"count", std::to_string(step_.count)}}));
    indent_ = 4;
    for (auto const &[period, rows] : values_) {
      names_.insert(row_name(period));
      out_.statement(
          indent_,
          fill(language_, language_.loops.row,
               {{"name", row_name(period)}, {"table", values_name(period)}, {"index", begin_of_row(period, rows)}}));
    }
  }

  std::string begin_of_row(std::size_t period, ValueRows const &rows) const {
    bool const is_in_turn = period == step_.count;
    std::string const place = is_in_turn ? std::string(counter) : fmt::format("{} % {}", counter, period);
    std::string row = rows.is_listed() ? indexed(rows_name(period), place) : place;
    if (rows.columns.size() == 1) return row;
    return fmt::format("{}*{}", rows.columns.size(), is_in_turn || rows.is_listed() ? row : "(" + row + ")");
  }

  void set(std::string const &name, std::string const &value) {
    out_.statement(indent_, fill(language_, language_.statements.set, {{"name", name}, {"value", value}}));
  }

  Emission &emission_;
  Language const &language_;
  Step const &step_;
  LoopArrays const &arrays_;
  CodeText &out_;
  std::set<std::string> &used_;
  std::set<std::string> names_;
  std::map<std::size_t, ValueRows> values_; // by their periods
  std::size_t element_tables_ = 0, indent_ = 2;
};

} // namespace

void print_step(Emission &emission, reroll::Step const &step, LoopArrays const &arrays, CodeText &out,
                std::set<std::string> &used) {
  StepPrinter(emission, step, arrays, out, used).print();
}

} // namespace symreal
