// Number tables: the constants that loops read, as tables with a row per iteration; their choice, and their text.
//
// Loops with equal numbers share a table: one may read its rows backwards, start in the middle, or have fewer
// iterations.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"
#include "engine/plan/loop_function.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

struct NumberTable {
  std::size_t rows;
  bool is_cyclic; // the first row follows the last one
  std::vector<std::vector<double>> columns = {};
  std::size_t walks = 0;                   // number of loops that read it
  std::vector<std::uint32_t> written = {}; // stored rows, in order: equal rows are stored once,
  std::vector<std::uint32_t> which = {};   // and this maps each row to a stored one; empty if most rows differ

  bool is_listed() const { return !which.empty(); }
};

// Row of iteration k: first + k, or first - k.
struct TableWalk {
  std::size_t table;
  std::size_t first = 0;
  bool is_backwards = false;
  bool by_turn = false; // k counts iterations of the outer loop
  auto operator<=>(TableWalk const &) const = default;
};

std::size_t row_of(TableWalk const &walk, NumberTable const &table, std::size_t k);

// Positions of a step's numbers in the tables.
struct StepNumbers {
  struct Place {
    std::size_t walk, column;
  };
  std::vector<TableWalk> walks = {};
  std::vector<Place> places = {}; // per leaf of kind `values`
};

class NumberTables {
public:
  explicit NumberTables(std::vector<reroll::LoopStep> const &steps);

  std::vector<NumberTable> const &tables() const { return tables_; }
  std::vector<StepNumbers> const &steps() const { return steps_; }

private:
  struct Columns; // of one step
  void place(Columns rest);

  std::vector<NumberTable> tables_;
  std::vector<StepNumbers> steps_;
};

// The tables of a function, and their names.
class LoopTables {
public:
  LoopTables(Language const &language, std::string_view function, std::vector<reroll::LoopStep> const &steps);

  StepNumbers const &of_step(std::size_t step) const { return numbers_.steps()[step]; }
  NumberTable const &table(std::size_t table) const { return numbers_.tables()[table]; }
  // Name of a table: one that several loops share is printed before the function; another is printed before its loop
  // under this name, if it is free.
  std::string const &name(std::size_t table) const { return names_[table]; }
  bool is_shared(std::size_t table) const { return this->table(table).walks > 1; }
  void print_shared(Emission &emission, CodeText &out) const;

private:
  NumberTables numbers_;
  std::vector<std::string> names_;
};

// Name of the list that maps each row of a table to the row stored for it.
std::string rows_name(std::string const &table_name);
// `indent`: of its lines.
void print_number_table(Emission &emission, std::size_t indent, std::string const &name, NumberTable const &table,
                        CodeText &out);
void print_element_table(Language const &language, std::size_t indent, std::string const &name,
                         std::vector<std::uint32_t> const &elements, CodeText &out);

// Index at which the row of an iteration begins; `count`: name of the loop counter.
std::string begin_of_row(Language const &language, TableWalk const &walk, NumberTable const &table,
                         std::string const &name, std::string_view count);

} // namespace symreal
