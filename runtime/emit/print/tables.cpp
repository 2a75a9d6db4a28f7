#include "emit/print/tables.h"

#include "emit/language/pattern.h"

namespace symreal {

static std::string print_table(Emission const &emission, std::size_t number) {
  Language const &language = emission.language;
  Table const &table = emission.graph().tables[number];
  std::string label; // a comment must not end in the user's text
  for (char c : table.name) label += c == '*' || c == '/' ? ' ' : c;
  std::string const name = "table_" + std::to_string(number), count = std::to_string(table.values.size());
  std::string text =
      comment(language, {label}) + "\n" + fill(language.tables.begin, {{"name", name}, {"count", count}});
  std::size_t const row = table.extents.back(), most = language.lines.width - 4;
  std::size_t width = 0;
  for (std::size_t k = 0; k < table.values.size(); ++k) {
    std::string const value = constant(language, table.values[k]) + (k + 1 < table.values.size() ? "," : "");
    bool const breaks = k % row == 0 || width + value.size() + language.lines.continuation.size() > most;
    text += breaks ? std::string(language.lines.continuation) + "\n    " + value : " " + value;
    width = (breaks ? 0 : width + 1) + value.size();
  }
  return text + fill(language.tables.end, {{"name", name}, {"count", count}}) + "\n";
}

std::string print_tables(Emission const &emission) {
  std::string text;
  for (std::size_t number : emission.uses.tables) text += print_table(emission, number);
  if (!text.empty()) text.append("\n").append(emission.language.tables.index_helper);
  return text;
}

} // namespace symreal
