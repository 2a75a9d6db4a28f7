#include "emit/print/loop_step.h"

#include "emit/print/body.h"
#include "emit/print/loop_indices.h"
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

class StepPrinter {
public:
  StepPrinter(Emission &emission, Step const &step, LoopArrays const &arrays, CodeText &out,
              std::set<std::string> &used)
      : emission_(emission),
        language_(emission.language),
        step_(step),
        indices_(emission.language, step),
        names_(indices_.names()),
        arrays_(arrays),
        out_(out),
        used_(used) {}

  void print() {
    std::vector<std::string> const leaves = spell_leaves();
    std::vector<std::string> stores;
    for (Store const &store : step_.stores)
      stores.push_back(element(store.is_result ? arrays_.filled : arrays_.memory, store.access));
    for (auto &[shape, rows] : values_) print_values(shape, rows);
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
  // Compilers may unroll a loop and see what a table holds.
  std::vector<char> constant_leaves() const {
    std::vector<char> constant;
    for (Leaf const &leaf : step_.leaves)
      constant.push_back(arrays_.may_be_constant && !reroll::is_argument(leaf.kind));
    return constant;
  }

  std::vector<std::string> spell_leaves() {
    std::vector<std::size_t> column; // of a leaf in its table
    for (Leaf const &leaf : step_.leaves) {
      std::vector<std::vector<double> const *> *const columns =
          leaf.kind == Leaf::Kind::values ? &values_[shape_of(leaf)].columns : nullptr;
      column.push_back(columns ? columns->size() : 0);
      if (columns) columns->push_back(&leaf.values);
    }
    std::vector<std::string> leaves;
    for (std::size_t k = 0; k < step_.leaves.size(); ++k)
      leaves.push_back(step_.leaves[k].kind == Leaf::Kind::values ? value(shape_of(step_.leaves[k]), column[k])
                                                                  : spell(step_.leaves[k], k));
    return leaves;
  }

  // What stays the same stands before the loop: compilers cannot know that no store changes it.
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

  std::string element(std::string const &array, Access const &access) {
    used_.insert(array);
    std::optional<std::string> const index = indices_.of_element(access);
    return indexed(array, index ? *index : indexed(element_table(access.elements), indices_.of_iteration()));
  }
  std::string indexed(std::string_view array, std::string const &index) const {
    return fill(language_, language_.expressions.element, {{"array", array}, {"index", index}});
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

  // Values of one period stand in one table, those of an iteration, or of a turn of the outer of two loops, in a row.
  struct Shape {
    std::size_t period;
    bool by_turn;
    auto operator<=>(Shape const &) const = default;
  };
  static Shape shape_of(Leaf const &leaf) { return {leaf.values.size(), leaf.by_turn}; }

  std::string value(Shape shape, std::size_t column) const { return indexed(row_name(shape), std::to_string(column)); }
  static std::string values_name(Shape shape) { return fmt::format("{}values_{}", turn_of(shape), shape.period); }
  static std::string row_name(Shape shape) { return fmt::format("{}row_{}", turn_of(shape), shape.period); }
  static std::string rows_name(Shape shape) { return fmt::format("{}rows_{}", turn_of(shape), shape.period); }
  static std::string_view turn_of(Shape shape) { return shape.by_turn ? "turn_" : ""; }

  void print_values(Shape shape, ValueRows &rows) {
    write_once(rows);
    std::vector<std::string> words;
    for (std::uint32_t const row : rows.written)
      for (auto const *column : rows.columns) {
        words.push_back(constant(language_, (*column)[row]));
        emission_.uses.not_finite = emission_.uses.not_finite || !std::isfinite((*column)[row]);
      }
    print_table(language_.tables.begin, language_.tables.end, values_name(shape), words);
    if (rows.is_listed()) print_element_table(rows_name(shape), rows.which);
  }

  void print_table(std::string_view begin, std::string_view end, std::string const &name,
                   std::vector<std::string> const &words) {
    names_.insert(name);
    std::string const count = std::to_string(words.size());
    out_.lines("  " + fill(language_, begin, {{"name", name}, {"count", count}}) + lines_of(language_, words) +
               fill(language_, end, {{"name", name}, {"count", count}}) + "\n");
  }

  // Where the rows of tables begin, statements of the body, or of the outer of two loops.
  std::vector<std::string> spell_rows() {
    std::vector<std::string> statements;
    for (auto const &[shape, rows] : values_) {
      names_.insert(row_name(shape));
      (shape.by_turn ? of_turn_ : statements)
          .push_back(
              fill(language_, language_.loops.row,
                   {{"name", row_name(shape)}, {"table", values_name(shape)}, {"index", begin_of_row(shape, rows)}}));
    }
    return statements;
  }

  std::string begin_of_row(Shape shape, ValueRows const &rows) {
    std::string const count = shape.by_turn ? indices_.of_turn() : indices_.of_iteration();
    bool const is_in_turn = shape.period == (shape.by_turn ? indices_.turns() : step_.count);
    std::string const place = is_in_turn ? count : fmt::format("{} % {}", count, shape.period);
    std::string row = rows.is_listed() ? indexed(rows_name(shape), place) : place;
    if (rows.columns.size() == 1) return row;
    return fmt::format("{}*{}", rows.columns.size(), is_in_turn || rows.is_listed() ? row : "(" + row + ")");
  }

  void set(std::string const &name, std::string const &value) {
    out_.statement(indent_, fill(language_, language_.statements.set, {{"name", name}, {"value", value}}));
  }

  Emission &emission_;
  Language const &language_;
  Step const &step_;
  LoopIndices indices_;
  std::set<std::string> names_; // that the body must not take
  LoopArrays const &arrays_;
  CodeText &out_;
  std::set<std::string> &used_;
  std::map<Shape, ValueRows> values_;
  std::vector<std::string> of_turn_; // statements of the outer of two loops
  std::size_t element_tables_ = 0, indent_ = 2;
};

} // namespace

void print_step(Emission &emission, reroll::Step const &step, LoopArrays const &arrays, CodeText &out,
                std::set<std::string> &used) {
  StepPrinter(emission, step, arrays, out, used).print();
}

} // namespace symreal
