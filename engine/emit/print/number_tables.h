// The numbers that the loops of a function go through, as tables with a row for each iteration.
//
// Loops that go through the same numbers share a table: one may go through its rows backwards, begin in the middle, or
// go round less often.
#pragma once

#include "engine/plan/reroll/loop_program.h"

#include <cstdint>
#include <vector>

namespace symreal {

struct NumberTable {
  std::size_t rows;
  bool is_cyclic; // behind the last row comes the first one
  std::vector<std::vector<double>> columns = {};
  std::size_t walks = 0;                   // of loops, through it
  std::vector<std::uint32_t> written = {}; // rows, in order: those that are alike are written once,
  std::vector<std::uint32_t> which = {};   // and this says per row where; empty where most rows differ

  bool is_listed() const { return !which.empty(); }
};

// In iteration k: row first + k, or first - k.
struct TableWalk {
  std::size_t table;
  std::size_t first = 0;
  bool is_backwards = false;
  bool by_turn = false; // k counts the turns of the outer of two loops
  auto operator<=>(TableWalk const &) const = default;
};

std::size_t row_of(TableWalk const &walk, NumberTable const &table, std::size_t k);

// Where the numbers of a step stand.
struct StepNumbers {
  struct Place {
    std::size_t walk, column;
  };
  std::vector<TableWalk> walks = {};
  std::vector<Place> places = {}; // per leaf, of those that stand for numbers
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
