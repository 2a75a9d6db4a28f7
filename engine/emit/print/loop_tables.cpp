#include "engine/emit/print/loop_tables.h"

#include "engine/emit/print/loop_indices.h"
#include "engine/emit/print/module.h"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace symreal {

namespace {

void print_table(Language const &language, std::size_t indent, std::string_view begin, std::string_view end,
                 std::string const &name, std::vector<std::string> const &words, CodeText &out) {
  std::string const count = std::to_string(words.size());
  out.lines(std::string(indent, ' ') + fill(language, begin, {{"name", name}, {"count", count}}) +
            lines_of(language, words) + fill(language, end, {{"name", name}, {"count", count}}) + "\n");
}

} // namespace

LoopTables::LoopTables(Language const &language, std::string_view function, std::vector<reroll::Step> const &steps)
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
