#include "engine/emit/print/number_tables.h"

#include "engine/emit/print/loop_indices.h"
#include "engine/support/number.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace symreal {

using reroll::Leaf;
using reroll::LoopStep;

namespace {

using Column = std::vector<double>;

bool is_at(Column const &column, TableWalk const &walk, NumberTable const &table, Column const &there) {
  for (std::size_t k = 0; k < column.size(); ++k)
    if (!same_bits(column[k], there[row_of(walk, table, k)])) return false;
  return true;
}

std::size_t find_column(Column const &column, TableWalk const &walk, NumberTable const &table) {
  auto const is_it = [&](Column const &there) { return is_at(column, walk, table, there); };
  return static_cast<std::size_t>(std::ranges::find_if(table.columns, is_it) - table.columns.begin());
}

// Whether a walk of `count` iterations stays inside the table.
bool stays_inside(TableWalk const &walk, NumberTable const &table, std::size_t count) {
  return table.is_cyclic || (walk.is_backwards ? walk.first + 1 >= count : walk.first + count <= table.rows);
}

void write_once(NumberTable &table) {
  std::map<std::vector<std::uint64_t>, std::uint32_t> known;
  for (std::uint32_t row = 0; row < table.rows; ++row) {
    std::vector<std::uint64_t> key;
    for (Column const &column : table.columns) key.push_back(std::bit_cast<std::uint64_t>(column[row]));
    auto const [entry, is_new] = known.try_emplace(std::move(key), static_cast<std::uint32_t>(table.written.size()));
    if (is_new) table.written.push_back(row);
    table.which.push_back(entry->second);
  }
  if (2 * table.written.size() <= table.rows) return;
  table.which.clear();
  table.written.resize(table.rows);
  std::iota(table.written.begin(), table.written.end(), 0U);
}

} // namespace

std::size_t row_of(TableWalk const &walk, NumberTable const &table, std::size_t k) {
  if (!table.is_cyclic) return walk.is_backwards ? walk.first - k : walk.first + k;
  std::size_t const turn = k % table.rows;
  return (walk.is_backwards ? walk.first + table.rows - turn : walk.first + turn) % table.rows;
}

// Columns of one step with equal length and, for all of them, the same `by_turn` and `is_cyclic`.
struct NumberTables::Columns {
  std::size_t step;
  bool by_turn, is_cyclic;
  std::vector<std::size_t> leaves = {};
  std::vector<Column const *> values = {};

  std::size_t size() const { return values.front()->size(); }
  void add(std::size_t leaf, Column const &column) {
    leaves.push_back(leaf);
    values.push_back(&column);
  }

  // Walks through the table that reproduce at least one column; incomplete if a number occurs in many places.
  std::set<TableWalk> walks(std::size_t number, NumberTable const &table) const {
    constexpr std::size_t most_columns = 16, most_places = 64;
    std::set<TableWalk> walks;
    for (std::size_t c = 0; c < std::min(values.size(), most_columns); ++c)
      for (Column const &there : table.columns) {
        std::size_t places = 0;
        for (std::size_t row = 0; row < there.size() && places < most_places; ++row) {
          if (!same_bits(values[c]->front(), there[row])) continue;
          ++places;
          for (bool const is_backwards : {false, true}) {
            TableWalk const walk{number, row, is_backwards, by_turn};
            if (stays_inside(walk, table, size()) && is_at(*values[c], walk, table, there)) walks.insert(walk);
          }
        }
      }
    return walks;
  }

  // The walk that reproduces the most columns, at least a quarter.
  std::optional<TableWalk> best_walk(std::vector<NumberTable> const &tables) const {
    std::optional<TableWalk> best;
    std::size_t most = (values.size() - 1) / 4;
    for (std::size_t number = 0; number < tables.size(); ++number) {
      NumberTable const &table = tables[number];
      bool const may_fit = is_cyclic == table.is_cyclic && (is_cyclic ? size() == table.rows : size() <= table.rows);
      if (!may_fit) continue;
      for (TableWalk const &walk : walks(number, table)) {
        auto const found = static_cast<std::size_t>(std::ranges::count_if(
            values, [&](Column const *column) { return find_column(*column, walk, table) != table.columns.size(); }));
        if (found > most) most = found, best = walk;
      }
    }
    return best;
  }
};

NumberTables::NumberTables(std::vector<LoopStep> const &steps) : steps_(steps.size()) {
  std::vector<Columns> all;
  for (std::size_t number = 0; number < steps.size(); ++number) {
    LoopStep const &step = steps[number];
    steps_[number].places.resize(step.leaves.size());
    std::map<std::pair<std::size_t, bool>, Columns> of_step;
    for (std::size_t k = 0; k < step.leaves.size(); ++k) {
      Leaf const &leaf = step.leaves[k];
      if (leaf.array != Array::values) continue;
      std::size_t const count = leaf.by_turn && step.nest ? step.nest->turns : step.count;
      Columns empty{number, leaf.by_turn, leaf.values.size() < count};
      of_step.try_emplace({leaf.values.size(), leaf.by_turn}, std::move(empty)).first->second.add(k, leaf.values);
    }
    for (auto &[shape, columns] : of_step) all.push_back(std::move(columns));
  }
  // The longest columns, and of equal ones the largest groups, come first: others may reuse their tables.
  std::ranges::stable_sort(all, std::greater<>(),
                           [](Columns const &columns) { return std::pair(columns.size(), columns.values.size()); });
  for (Columns &columns : all) place(std::move(columns));
  for (std::size_t number = 0; number < steps.size(); ++number)
    for (std::size_t k = 0; k < steps[number].leaves.size(); ++k) {
      Leaf const &leaf = steps[number].leaves[k];
      if (leaf.array != Array::values) continue;
      auto const [walk, column] = steps_[number].places[k];
      TableWalk const &on = steps_[number].walks[walk];
      internal_check(is_at(leaf.values, on, tables_[on.table], tables_[on.table].columns[column]));
    }
  for (NumberTable &table : tables_) write_once(table);
}

void NumberTables::place(Columns rest) {
  StepNumbers &numbers = steps_[rest.step];
  constexpr std::size_t none = ~std::size_t{0};
  std::size_t filled = none; // walk through a table that can take new columns
  auto const add_walk = [&](TableWalk const &walk) {
    numbers.walks.push_back(walk);
    ++tables_[walk.table].walks;
    if (filled == none && tables_[walk.table].rows == rest.size()) filled = numbers.walks.size() - 1;
    return numbers.walks.size() - 1;
  };
  while (std::optional<TableWalk> const walk = rest.best_walk(tables_)) {
    NumberTable const &table = tables_[walk->table];
    std::size_t const number = add_walk(*walk);
    Columns others{rest.step, rest.by_turn, rest.is_cyclic};
    for (std::size_t k = 0; k < rest.values.size(); ++k) {
      std::size_t const column = find_column(*rest.values[k], *walk, table);
      if (column == table.columns.size())
        others.add(rest.leaves[k], *rest.values[k]);
      else
        numbers.places[rest.leaves[k]] = {number, column};
    }
    if (others.values.empty()) return;
    rest = std::move(others);
  }
  if (filled == none) {
    tables_.push_back({rest.size(), rest.is_cyclic});
    add_walk({.table = tables_.size() - 1, .by_turn = rest.by_turn});
  }
  TableWalk const &walk = numbers.walks[filled];
  NumberTable &table = tables_[walk.table];
  for (std::size_t k = 0; k < rest.values.size(); ++k) {
    std::size_t const column = find_column(*rest.values[k], walk, table);
    numbers.places[rest.leaves[k]] = {filled, column};
    if (column != table.columns.size()) continue;
    table.columns.emplace_back(table.rows);
    for (std::size_t i = 0; i < table.rows; ++i) table.columns[column][row_of(walk, table, i)] = (*rest.values[k])[i];
  }
}

namespace {

void print_table(Language const &language, std::size_t indent, std::string_view begin, std::string_view end,
                 std::string const &name, std::vector<std::string> const &words, CodeText &out) {
  std::string const count = std::to_string(words.size());
  out.lines(std::string(indent, ' ') + fill(language, begin, {{"name", name}, {"count", count}}) +
            lines_of(language, words) + fill(language, end, {{"name", name}, {"count", count}}) + "\n");
}

} // namespace

LoopTables::LoopTables(Language const &language, std::string_view function, std::vector<reroll::LoopStep> const &steps)
    : numbers_(steps) {
  std::map<std::size_t, std::size_t> shared; // per row count
  for (std::size_t k = 0; k < numbers_.tables().size(); ++k) {
    std::string const name = fmt::format("values_{}", table(k).rows);
    if (!is_shared(k)) {
      names_.push_back(name);
      continue;
    }
    std::size_t const number = ++shared[table(k).rows];
    std::string const end = number == 1 ? "" : fmt::format("_{}", number);
    names_.push_back(language.names.spelled(fmt::format("{}_{}{}", function, name, end)));
  }
}

void LoopTables::print_shared(Emission &emission, CodeText &out) const {
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (!is_shared(k)) continue;
    print_number_table(emission, 0, names_[k], table(k), out);
    out.lines("\n");
  }
}

std::string rows_name(std::string const &table_name) { return table_name + "_rows"; }

void print_number_table(Emission &emission, std::size_t indent, std::string const &name, NumberTable const &table,
                        CodeText &out) {
  Language const &language = emission.language;
  std::vector<std::string> words;
  for (std::uint32_t const row : table.written)
    for (std::vector<double> const &column : table.columns) {
      words.push_back(constant(language, column[row]));
      emission.uses.not_finite = emission.uses.not_finite || !std::isfinite(column[row]);
    }
  print_table(language, indent, language.tables.begin, language.tables.end, name, words, out);
  if (table.is_listed()) print_element_table(language, indent, rows_name(name), table.which, out);
}

void print_element_table(Language const &language, std::size_t indent, std::string const &name,
                         std::vector<std::uint32_t> const &elements, CodeText &out) {
  std::vector<std::string> words;
  for (std::uint32_t const element : elements) words.push_back(std::to_string(element));
  print_table(language, indent, language.loops.element_table, language.loops.table_end, name, words, out);
}

std::string begin_of_row(Language const &language, TableWalk const &walk, NumberTable const &table,
                         std::string const &name, std::string_view count) {
  auto const first = static_cast<std::int64_t>(walk.first);
  std::string row = std::string(count);
  if (!table.is_cyclic)
    row = index_text(first, {{walk.is_backwards ? -1 : 1, count}});
  else if (walk.is_backwards)
    row = fmt::format("({} - {} % {}) % {}", walk.first + table.rows, count, table.rows, table.rows);
  else
    row = walk.first == 0 ? fmt::format("{} % {}", count, table.rows)
                          : fmt::format("({} + {}) % {}", count, walk.first, table.rows);
  if (table.is_listed())
    row = fill(language, language.expressions.element, {{"array", rows_name(name)}, {"index", row}});
  if (table.columns.size() == 1) return row;
  bool const is_sum = row != count && !table.is_listed();
  return fmt::format("{}*{}", table.columns.size(), is_sum ? "(" + row + ")" : row);
}

} // namespace symreal
