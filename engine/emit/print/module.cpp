#include "engine/emit/print/module.h"

#include "engine/emit/print/banner.h"
#include "engine/emit/print/code_text.h"
#include "engine/graph/names.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <ranges>

namespace symreal {

std::vector<std::string> output_names(Emission const &emission) {
  return element_names(emission.graph().outputs, emission.language.names);
}

std::vector<std::string> constants(Language const &language, std::vector<double> const &values) {
  std::vector<std::string> texts;
  for (double const value : values) texts.push_back(constant(language, value));
  return texts;
}

namespace {

// Offsets of `count` lines in a list of elements that is sorted by line.
std::vector<std::size_t> starts(std::vector<std::uint32_t> const &lines, std::size_t count) {
  std::vector<std::size_t> result(count + 1, 0);
  for (std::uint32_t const line : lines) ++result[line + std::size_t{1}];
  std::partial_sum(result.begin(), result.end(), result.begin());
  return result;
}

std::vector<IndexList> index_lists(DerivativeMatrix const &matrix, std::size_t base) {
  std::vector<std::size_t> by_column(matrix.row.size()), row_by_column;
  std::iota(by_column.begin(), by_column.end(), 0);
  std::ranges::stable_sort(by_column, {}, [&](std::size_t k) { return matrix.column[k]; });
  for (std::size_t const k : by_column) row_by_column.push_back(matrix.row[k]);
  std::vector<IndexList> lists = {{"row", {matrix.row.begin(), matrix.row.end()}},
                                  {"column", {matrix.column.begin(), matrix.column.end()}},
                                  {"row_start", starts(matrix.row, matrix.rows)},
                                  {"column_start", starts(matrix.column, matrix.columns)},
                                  {"row_by_column", row_by_column},
                                  {"by_column", by_column}};
  for (IndexList &list : lists)
    for (std::size_t &index : list.values) index += base;
  return lists;
}

std::string storage_of(DerivativeMatrix const &matrix, bool is_full) {
  if (is_full) return "no element is zero by structure";
  if (!matrix.is_packed) return "all elements are stored, and those listed are not zero by structure";
  if (matrix.is_symmetric)
    return "those listed are stored, in this order; the matrix is symmetric, and nothing above its diagonal is listed";
  return "those listed are stored, in this order; the others are zero by structure";
}

} // namespace

std::vector<std::string> IndexList::texts() const {
  std::vector<std::string> result;
  for (std::size_t const value : values) result.push_back(std::to_string(value));
  return result;
}

std::string matrix_remark(Emission const &emission, MatrixText const &matrix) {
  std::vector<std::string> lines = {"The matrix " + matrix.name + ": " + matrix.storage + "."};
  if (!matrix.lists.empty())
    lines.insert(lines.end(),
                 {"Element k of those listed stands in row[k] and column[k]. Row i has those from row_start[i] up to",
                  "row_start[i + 1]. Column by column, column j has the places from column_start[j] up to",
                  "column_start[j + 1]: there are the rows in row_by_column, and in by_column the numbers k."});
  return comment(emission.language, lines, lines.size() > 1) + "\n";
}

std::vector<MatrixText> matrix_texts(Emission const &emission) {
  Graph const &graph = emission.graph();
  std::vector<std::string> const names = identifiers(graph.outputs, emission.language.names);
  std::vector<MatrixText> texts;
  for (DerivativeMatrix const &matrix : graph.matrices) {
    bool const is_full = matrix.row.size() == std::size_t{matrix.rows} * matrix.columns;
    texts.push_back(
        {names[matrix.output], storage_of(matrix, is_full), matrix.rows, matrix.columns, matrix.row.size(), {}});
    if (!is_full) texts.back().lists = index_lists(matrix, emission.language.expressions.first_index);
  }
  return texts;
}

namespace {

constexpr std::string_view functions[] = {"preprocess", "compute", "guard_text"};

struct Size {
  std::string name;
  std::size_t value;
};

std::vector<Size> sizes(Emission const &emission) {
  Graph const &graph = emission.graph();
  return {{"input", graph.input_count()},
          {"parameter", graph.parameter_count()},
          {"constant", emission.plan.constant_count},
          {"output", graph.output_count()},
          {"guard", graph.guards.size()}};
}

} // namespace

Filling interface_names(Emission const &emission) {
  Filling fill;
  std::string const prefix = emission.options.prefix;
  NameRules const &rules = emission.language.names;
  fill.set_name("module", rules.spelled(identifier(prefix.empty() ? emission.graph().kernel : prefix, rules)));
  fill.set("base", emission.options.base_name).set_name("unit", identifier(emission.options.base_name, rules));
  fill.set("package",
           emission.options.extras.contains("mainline") ? "main" : identifier(emission.options.base_name, rules));
  for (auto const &[name, text] : words_of(emission.language)) fill.set(std::string(name), std::string(text));
  for (std::string_view const name : functions) fill.set_name(std::string(name), emission.name(std::string(name)));
  for (Size const &size : sizes(emission)) {
    fill.set_name(size.name + "_count", emission.name(size.name + "_count"));
    fill.set(size.name + "s", size.value);
  }
  return fill;
}

namespace {

std::string list(std::vector<std::size_t> const &extents) { return fmt::format("{}", fmt::join(extents, ", ")); }

// Type of an object, built from the innermost extent outwards.
std::string type_of(Language const &language, ObjectsSyntax const &syntax, Object const &object) {
  std::string type = with_words(language, syntax.number);
  auto const wrap = [&](std::size_t extent) {
    type = fill(language, syntax.array, {{"element", type}, {"extent", std::to_string(extent)}});
  };
  if (!object.members.empty()) {
    wrap(object.count);
    return type;
  }
  for (std::size_t const extent : object.extents | std::views::reverse) wrap(extent);
  return type;
}

std::string objects(Emission const &emission, ObjectsSyntax const &syntax, std::string const &role,
                    std::vector<Object> const &all) {
  if (syntax.object.empty()) return {};
  Filling fill = interface_names(emission);
  fill.set_name("role", emission.name(role));
  fill.set("count", all.empty() ? 0 : all.back().first + all.back().count);
  NameRules const rules{emission.language.names.keywords, /*ignores_case=*/true}; // names may be converted to capitals
  std::vector<std::string> const names = identifiers(all, rules);
  std::size_t const base = emission.language.expressions.first_index;
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].count == 0) continue;
    std::vector<std::size_t> extents = all[i].extents;
    if (!all[i].members.empty()) extents = {all[i].count}; // a flat list of its numbers
    std::vector<std::size_t> const reversed(extents.rbegin(), extents.rend());
    fill.set_name("name", names[i])
        .set("first", all[i].first + base)
        .set("extents", list(extents))
        .set("extents_comma", list(extents) + (extents.size() == 1 ? "," : ""))
        .set("more_extents", (extents.empty() ? "" : ", ") + list(extents))
        .set("reversed_shape", reversed.empty() ? "" : "(" + list(reversed) + ")")
        .set("type", type_of(emission.language, syntax, all[i]));
    text += (text.empty() ? "" : std::string(syntax.separator)) + fill(syntax.object);
  }
  return text.empty() ? text : fill(syntax.begin) + text + fill(syntax.end);
}

std::string all_objects(Emission const &emission, ObjectsSyntax const &syntax) {
  Graph const &graph = emission.graph();
  return objects(emission, syntax, "input", graph.inputs) + objects(emission, syntax, "parameter", graph.parameters) +
         objects(emission, syntax, "output", graph.outputs);
}

// `fill` has the name of the list.
std::string index_list(Emission const &emission, Filling fill, std::string const &name,
                       std::vector<std::string> const &values) {
  ModuleSyntax const &syntax = emission.language.module;
  fill.set("count", values.size());
  std::size_t const most = syntax.most_indices, base = emission.language.expressions.first_index;
  if (most == 0 || values.size() <= most)
    return fill.set("values", lines_of(emission.language, values))(syntax.index_list);
  std::string text = fill(syntax.long_index_list);
  std::vector<std::string> parts;
  for (std::size_t first = 0; first < values.size(); first += most) {
    std::size_t const last = std::min(first + most, values.size());
    parts.push_back(emission.language.names.spelled(name + "_" + std::to_string(parts.size() + 1)));
    fill.set_name("part", parts.back()).set("first", first + base).set("last", last - 1 + base);
    text += fill.set("values", lines_of(emission.language, {values.begin() + static_cast<std::ptrdiff_t>(first),
                                                            values.begin() + static_cast<std::ptrdiff_t>(last)}))(
        syntax.index_part);
  }
  return text + fill.set("parts", lines_of(emission.language, parts))(syntax.joined_indices);
}

std::string matrices(Emission const &emission) {
  ModuleSyntax const &syntax = emission.language.module;
  if (syntax.index_list.empty()) return {};
  Filling fill = interface_names(emission);
  std::string text;
  for (MatrixText const &matrix : matrix_texts(emission)) {
    text += "\n" + indented(emission.language, matrix_remark(emission, matrix));
    for (auto const &[name, value] : matrix.sizes())
      text += fill.set_name("name", emission.name(matrix.name + "_" + name)).set("value", value)(syntax.size);
    for (IndexList const &list : matrix.lists) {
      std::string const name = emission.name(matrix.name + "_" + std::string(list.name));
      text += index_list(emission, fill.set_name("name", name), name, list.texts());
    }
  }
  return text;
}

} // namespace

std::string module_begin(Emission const &emission) {
  ModuleSyntax const &syntax = emission.language.module;
  Filling fill = interface_names(emission);
  std::string text = fill(syntax.begin);
  for (Size const &size : sizes(emission))
    if (size.name != "guard" || size.value != 0)
      text += fill.set_name("name", emission.name(size.name + "_count")).set("value", size.value)(syntax.size);
  text += matrices(emission);
  text += all_objects(emission, syntax.places) + all_objects(emission, syntax.structure);
  text += fill(syntax.packing) + fill(syntax.functions) + indented(emission.language, frozen_remark(emission));
  if (!emission.graph().guards.empty()) text += indented(emission.language, guard_remark(emission) + "\n");
  return text;
}

std::string module_end(Emission const &emission) {
  ModuleSyntax const &syntax = emission.language.module;
  Graph const &graph = emission.graph();
  Filling fill = interface_names(emission);
  std::string text;
  if (!graph.guards.empty()) {
    text += fill(syntax.guards_begin);
    for (std::size_t k = 0; k < graph.guards.size(); ++k)
      text += fill.set("number", k + 1)
                  .set("text", literal(emission.language, guard_text(graph, graph.guards[k])))(syntax.guard);
    text += fill(syntax.guards_end);
  } else {
    text += fill(syntax.no_guards);
  }
  return text + fill(syntax.end);
}

Filling module_facts(Emission const &emission) {
  Language const &language = emission.language;
  Graph const &graph = emission.graph();
  std::vector<std::string> labels = output_names(emission);
  std::size_t longest = 0;
  for (std::string &label : labels) {
    longest = std::max(longest, label.size());
    label = literal(language, label);
  }
  Filling fill = interface_names(emission);
  fill.set("labels", lines_of(language, labels)).set("longest", longest);
  std::vector<double> all = graph.input_values;
  all.insert(all.end(), graph.parameter_values.begin(), graph.parameter_values.end());
  fill.set("all_values", lines_of(language, constants(language, all)));
  fill.set("input_values", lines_of(language, constants(language, graph.input_values)));
  fill.set("parameter_values", lines_of(language, constants(language, graph.parameter_values)));
  return fill;
}

std::string module_main(Emission const &emission) {
  ModuleSyntax const &syntax = emission.language.module;
  bool const has_guards = !emission.graph().guards.empty();
  Filling fill = module_facts(emission);
  fill.set("guard_text_import", has_guards ? ", " + emission.name("guard_text") : "");
  fill.set("call", fill(has_guards ? syntax.checked_call : syntax.call));
  return banner(emission) + fill(syntax.main);
}

} // namespace symreal
