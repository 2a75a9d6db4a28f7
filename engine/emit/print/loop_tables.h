// Printing of the tables that loops read (number_tables.h).
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/emit/print/emission.h"
#include "engine/emit/print/number_tables.h"

#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// The tables of a function.
class LoopTables {
public:
  LoopTables(Language const &language, std::string_view function, std::vector<reroll::Step> const &steps);

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
