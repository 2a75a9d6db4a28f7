// The text of the tables that loops go through (number_tables.h).
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
  // Of one that several loops go through, which stands before the function; of another, which stands in front of its
  // loop, what it may be called.
  std::string const &name(std::size_t table) const { return names_[table]; }
  bool is_shared(std::size_t table) const { return this->table(table).walks > 1; }
  void print_shared(Emission &emission, CodeText &out) const;

private:
  NumberTables numbers_;
  std::vector<std::string> names_;
};

// Which of the rows that are written each row of a table is.
std::string rows_name(std::string const &table_name);
// `indent`: before its lines.
void print_number_table(Emission &emission, std::size_t indent, std::string const &name, NumberTable const &table,
                        CodeText &out);
void print_element_table(Language const &language, std::size_t indent, std::string const &name,
                         std::vector<std::uint32_t> const &elements, CodeText &out);

// Where in the table the row of an iteration begins; `count` is the name of what counts them.
std::string begin_of_row(Language const &language, TableWalk const &walk, NumberTable const &table,
                         std::string const &name, std::string_view count);

} // namespace symreal
