// Number tables: the constants that loops read, as tables with a row per iteration.
//
// Loops with equal numbers share a table: one may read its rows backwards, start in the middle, or have fewer
// iterations.
#pragma once

#include "engine/plan/reroll/loop_program.h"

#include <cstdint>
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
  explicit NumberTables(std::vector<reroll::Step> const &steps);

  std::vector<NumberTable> const &tables() const { return tables_; }
  std::vector<StepNumbers> const &steps() const { return steps_; }

private:
  struct Columns; // of one step
  void place(Columns rest);

  std::vector<NumberTable> tables_;
  std::vector<StepNumbers> steps_;
};

} // namespace symreal
