#include "engine/emit/print/tables.h"

#include <algorithm>
#include <span>

namespace symreal {

namespace {

// The values from `first` on, as the lines of an array of this name.
std::string print_values(Language const &language, std::string const &name, std::span<double const> values,
                         std::size_t first, std::size_t row) {
  std::string const count = std::to_string(values.size()), mark(language.lines.continuation);
  std::string text = fill(language, language.tables.begin, {{"name", name}, {"count", count}});
  std::size_t const most = language.lines.width - 4;
  std::size_t width = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::string const value = constant(language, values[k]) + (k + 1 < values.size() ? "," : "");
    bool const breaks = (first + k) % row == 0 || k == 0 || width + value.size() + mark.size() > most;
    text += breaks ? mark + "\n    " + value : " " + value;
    width = (breaks ? 0 : width + 1) + value.size();
  }
  return text + fill(language, language.tables.end, {{"name", name}, {"count", count}}) + "\n";
}

std::string print_table(Emission const &emission, std::size_t number) {
  Language const &language = emission.language;
  Table const &table = emission.graph().tables[number];
  std::string const name = table_name(language, number);
  std::string text = comment(language, {in_comment(table.name)}) + "\n";
  std::size_t const row = table.extents.back();
  std::span<double const> const values = table.values;
  std::size_t const most = language.tables.most_values;
  if (most == 0 || values.size() <= most) return text + print_values(language, name, values, 0, row);
  std::string parts;
  std::size_t width = language.lines.width; // makes the first begin a line
  for (std::size_t first = 0; first < values.size(); first += most) {
    std::string const part = language.names.spelled(name + "_" + std::to_string(first / most + 1));
    text += print_values(language, part, values.subspan(first, std::min(most, values.size() - first)), first, row);
    bool const breaks = width + part.size() + 4 > language.lines.width - 4;
    parts += parts.empty() ? "" : ",";
    parts += breaks ? std::string(language.lines.continuation) + "\n    " : " ";
    width = (breaks ? 4 : width) + part.size() + 2;
    parts += part;
  }
  return text + fill(language, language.tables.joined,
                     {{"name", name}, {"parts", parts}, {"count", std::to_string(values.size())}});
}

} // namespace

std::string table_name(Language const &language, std::size_t number) {
  return language.names.spelled("table_" + std::to_string(number));
}

std::string print_tables(Emission const &emission) {
  std::string text;
  for (std::size_t number : emission.uses.tables) text += print_table(emission, number);
  if (!text.empty()) text.append("\n").append(with_words(emission.language, emission.language.tables.index_helper));
  return text;
}

} // namespace symreal
