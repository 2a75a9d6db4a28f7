#include "engine/emit/emit.h"

#include "engine/emit/print/banner.h"
#include "engine/emit/print/externals.h"
#include "engine/emit/print/function.h"
#include "engine/emit/requirements.h"

#include <algorithm>
#include <cctype>
#include <cmath>
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
  std::string const name = emission.table_name(number);
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

std::string print_tables(Emission const &emission) {
  std::string text;
  for (std::size_t number : emission.uses.tables) text += print_table(emission, number);
  std::string const helper = with_words(emission.language, emission.language.tables.index_helper);
  return text.empty() ? text : text + "\n" + helper + (helper.empty() ? "" : "\n");
}

bool has_word(std::string_view text, std::string_view word) {
  auto const is_part = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  for (std::size_t at = 0; (at = text.find(word, at)) != text.npos; at += word.size()) {
    bool const begins = at == 0 || !is_part(static_cast<unsigned char>(text[at - 1]));
    std::size_t const end = at + word.size();
    if (begins && (end == text.size() || !is_part(static_cast<unsigned char>(text[end])))) return true;
  }
  return false;
}

// Patterns of the language that have been used.
std::string printed_patterns(Emission const &emission) {
  Language const &language = emission.language;
  UsedFeatures const &uses = emission.uses;
  std::string text;
  auto const add = [&](bool is_used, std::string_view pattern) {
    if (is_used) text.append(pattern) += '\n';
  };
  for (OperationInfo const &operation : operations()) {
    auto const op = static_cast<std::size_t>(operation.op);
    add(uses.operations[op] || uses.spelled[op], emission.spellings.words(operation.op));
  }
  add(true, language.expressions.truth_as_number);
  add(uses.operations[static_cast<std::size_t>(Op::wide)], language.expressions.large_integer);
  add(uses.kept_integer, language.expressions.kept_integer);
  add(uses.keep_integer, language.statements.keep_integer);
  add(uses.hidden, language.expressions.hidden);
  add(!uses.tables.empty(), language.expressions.table_index);
  add(!uses.tables.empty(), language.tables.begin);
  auto const any_table = [&](auto const &test) {
    return std::ranges::any_of(uses.tables, [&](std::size_t k) { return test(emission.graph().tables[k].values); });
  };
  add(any_table([&](std::vector<double> const &values) { return values.size() > language.tables.most_values; }),
      language.tables.joined);
  bool const in_tables = any_table([](std::vector<double> const &values) {
    return !std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  });
  add(uses.not_finite || in_tables, language.numbers.infinity);
  add(uses.not_finite || in_tables, language.numbers.nan);
  add(uses.value_checks, language.statements.value_check);
  add(!emission.graph().guards.empty(), language.statements.check);
  return text;
}

// Helpers that printed spellings name, and transitively those that helpers name, in table order: their declarations, or
// their definitions.
std::string print_helpers(Emission const &emission, bool declarations) {
  std::span<Helper const> const helpers = emission.language.files.helpers;
  std::string const printed = printed_patterns(emission);
  std::vector<char> wanted(helpers.size(), 0);
  std::vector<std::size_t> found;
  auto const look = [&](std::string_view text) {
    for (std::size_t k = 0; k < helpers.size(); ++k)
      if (!wanted[k] && has_word(text, helpers[k].name)) {
        wanted[k] = 1;
        found.push_back(k);
      }
  };
  for (look(printed); !found.empty();) {
    std::size_t const helper = found.back();
    found.pop_back();
    look(helpers[helper].text);
  }
  std::string text;
  for (std::size_t k = 0; k < helpers.size(); ++k)
    if (wanted[k] && helpers[k].declares == declarations)
      text.append(with_words(emission.language, helpers[k].text)) += '\n';
  return text;
}

// The source file: the functions, preceded by the code that they use.
EmittedFile print_source(Emission &emission) {
  FileSyntax const &files = emission.language.files;
  std::string const name = emission.options.base_name + std::string(files.extension);
  if (files.whole) return {name, files.whole(emission)};
  CodeText functions(emission.language);
  for (PlanFunction const &function : emission.plan.functions) {
    if (&function != &emission.plan.functions.front()) functions.lines("\n");
    functions.append(print_function(emission, function));
  }
  auto const part = [&](Part write) { return write ? write(emission) : std::string(); };
  CodeText text(emission.language);
  text.lines(banner(emission));
  text.lines(part(files.begin));
  text.lines(part(emission.language.externals.declarations));
  text.lines(print_bridge_declarations(emission));
  text.lines(part(files.open));
  text.lines(indented(emission.language, print_tables(emission)));
  text.lines(part(files.integer_functions));
  if (emission.uses.hidden) text.lines(with_words(emission.language, files.hide_helper) + "\n");
  text.lines(part(emission.language.angles.helper));
  text.lines(indented(emission.language, print_helpers(emission, true)));
  text.lines(emission.language.module.contains);
  text.lines(indented(emission.language, print_helpers(emission, false)));
  text.lines(print_bridges(emission));
  text.append(std::move(functions));
  text.lines(part(files.end));
  return {name, text.take_text(), text.take_origins()};
}

std::vector<EmittedFile> print(Plan const &plan, Language const &language, EmitOptions const &options) {
  Emission emission{plan, language, options};
  std::vector<EmittedFile> files;
  files.push_back(print_source(emission)); // an initializer list would copy the text
  for (Companion const &companion : language.files.companions)
    if (companion.option.empty() || options.extras.contains(companion.option))
      files.push_back({options.base_name + std::string(companion.suffix), companion.text(emission)});
  require_other_names(emission, files);
  return files;
}

} // namespace

std::vector<EmittedFile> emit(Plan const &plan, Language const &language, EmitOptions const &options) {
  require_expressible(plan, language, options);
  auto const refuse = [&](char const *what) {
    fail(DiagnosticId::bad_option, {}, what + std::string(language.name) + " does not have");
  };
  if (plan.has_loops() && !language.loops.is_given()) refuse("--reroll needs loops, which --lang=");
  if (plan.vectors() && !language.vectors.is_given()) refuse("--vector needs vectors, which --lang=");
  if (plan.angles.size() != 0 && !language.angles.is_given())
    refuse("the plan begins with sines and cosines computed side by side, which --lang=");
  if (!options.is_single) return print(plan, language, options);
  require_single(*plan.graph, language, options);
  return print(plan, in_single_precision(language), options);
}

} // namespace symreal
