#include "engine/graph/graph_line.h"
#include "engine/graph/implicit.h"
#include "engine/graph/validate.h"

#include <array>
#include <ostream>

namespace symreal {

namespace {

using Kind = ExternalValue::Kind;

struct KindName {
  Kind kind;
  std::string_view name;
};
constexpr std::array<KindName, 6> kind_names = {{{Kind::number, "number"},
                                                 {Kind::integer, "integer"},
                                                 {Kind::input, "input"},
                                                 {Kind::output, "output"},
                                                 {Kind::updated, "updated"},
                                                 {Kind::object, "object"}}};

std::string_view name_of(Kind kind) {
  for (KindName const &known : kind_names)
    if (known.kind == kind) return known.name;
  return "";
}

ExternalValue read_value(Line &line) {
  std::string const &word = line.word("a parameter");
  for (KindName const &known : kind_names) {
    if (known.name != word) continue;
    ExternalValue value{known.kind, 1, {}};
    if (known.kind == Kind::integer)
      value.type = line.string("the type of the integer");
    else if (known.kind != Kind::number)
      value.count = line.count("number of doubles");
    return value;
  }
  line.error("'" + word + "' is not a kind of parameter");
}

void write_value(std::ostream &out, ExternalValue const &value) {
  out << ' ' << name_of(value.kind);
  if (value.kind == Kind::integer)
    out << ' ' << in_quotes(value.type);
  else if (value.kind != Kind::number)
    out << ' ' << value.count;
}

} // namespace

void read_table(Line &line, std::vector<Table> &tables) {
  if (line.count("table") != tables.size()) line.error("tables must follow each other from 0 on");
  Table table{line.string("the table's name"), line.extents(), {}, line.optional_place()};
  if (table.extents.empty() || table.extents.size() > 2) line.error("a table has one or two extents");
  std::size_t count = 1;
  for (std::size_t extent : table.extents) count *= extent;
  if (count == 0) line.error("a table has at least one element");
  if (!line.accept("=")) line.error("'=' is missing");
  for (std::size_t k = 0; k < count; ++k) table.values.push_back(line.number("a value"));
  tables.push_back(std::move(table));
}

void read_external(Line &line, std::vector<External> &externals) {
  if (line.count("function") != externals.size()) line.error("functions must follow each other from 0 on");
  External external{line.string("the function's name"), line.accept("pure"), {}, {}, {}};
  if (line.accept("returns")) external.returned = read_value(line);
  if (line.accept("takes"))
    while (!line.done() && line.peek() != "at" && line.peek() != "derivative")
      external.parameters.push_back(read_value(line));
  while (line.accept("derivative")) {
    bool const is_returned = line.accept("returned");
    external.derivatives.push_back({line.string("the name of its derivative"), is_returned});
  }
  std::string const violation = is_implicit(external) ? "" : find_violation(external);
  if (!violation.empty()) line.error(violation);
  external.place = line.optional_place();
  externals.push_back(std::move(external));
}

void write_tables(std::ostream &out, std::vector<Table> const &tables) {
  for (std::size_t k = 0; k < tables.size(); ++k) {
    out << "table " << k << ' ' << in_quotes(tables[k].name);
    for (std::size_t extent : tables[k].extents) out << " [" << extent << ']';
    write_place(out, tables[k].place);
    out << " =";
    for (double value : tables[k].values) out << ' ' << shortest(value);
    out << '\n';
  }
}

void write_externals(std::ostream &out, std::vector<External> const &externals) {
  for (std::size_t k = 0; k < externals.size(); ++k) {
    External const &external = externals[k];
    out << "external " << k << ' ' << in_quotes(external.name);
    if (external.pure) out << " pure";
    if (external.returned.kind != Kind::none) {
      out << " returns";
      write_value(out, external.returned);
    }
    if (!external.parameters.empty()) out << " takes";
    for (ExternalValue const &parameter : external.parameters) write_value(out, parameter);
    for (auto const &[name, is_returned] : external.derivatives)
      out << (is_returned ? " derivative returned " : " derivative ") << in_quotes(name);
    write_place(out, external.place);
    out << '\n';
  }
}

} // namespace symreal
