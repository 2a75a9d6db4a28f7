#include "engine/emit/print/helpers.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace symreal {

namespace {

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
  Uses const &uses = emission.uses;
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

} // namespace

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

} // namespace symreal
