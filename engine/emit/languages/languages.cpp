#include "engine/emit/languages/languages.h"

#include "engine/emit/c/parts.h"
#include "engine/emit/cpp/parts.h"
#include "engine/emit/language/language_file.h"
#include "engine/emit/languages/drawn.h"
#include "engine/emit/print/module.h"
#include "engine/emit/rust/parts.h"

#include <algorithm>
#include <mutex>

namespace symreal {

namespace {

constexpr LanguageRow rows[] = {
#define LANGUAGE(its_name, its_doc) {#its_name, its_doc},
#include "engine/emit/languages/languages.def"
#undef LANGUAGE
};

std::string no_part(Emission const &) { return {}; }
std::vector<std::string> no_call(ExternalCall const &) { return {}; }

#define CODE(function) {#function, function}
NamedCode const code[] = {
    CODE(module_begin),
    CODE(module_end),
    CODE(module_main),
    CODE(no_part),
    CODE(no_call),
    CODE(c_begin),
    CODE(c_end),
    CODE(c_header),
    CODE(c_mainline),
    CODE(c_mex),
    CODE(c_simulink),
    CODE(c_integer_functions),
    CODE(c_external_declarations),
    CODE(c_call),
    CODE(c_sines_and_cosines),
    CODE(cpp_begin),
    CODE(cpp_open),
    CODE(cpp_end),
    CODE(cpp_header),
    CODE(cpp_mainline),
    CODE(cpp_external_declarations),
    CODE(rust_begin),
    CODE(rust_end),
    CODE(rust_mainline),
    CODE(rust_integer_functions),
    CODE(latex_variable),
    CODE(dot_file),
};
#undef CODE

Language read(LanguageRow const &row) {
  LanguageFile table, texts;
  for (Asset const &file : language_files()) {
    if (!file.name.starts_with(row.name) || file.name[row.name.size()] != '.') continue;
    (file.name.ends_with(".toml") ? table : texts) = {file.name, file.text};
  }
  Language language = read_language(table, texts, code, find_language);
  language.name = row.name;
  language.doc = row.doc;
  return language;
}

} // namespace

std::span<LanguageRow const> languages() { return rows; }

Language const *find_language(std::string_view name) {
  static Language read_languages[std::size(rows)];
  static std::once_flag is_read[std::size(rows)];
  auto const k = static_cast<std::size_t>(std::ranges::find(rows, name, &LanguageRow::name) - rows);
  if (k == std::size(rows)) return nullptr;
  std::call_once(is_read[k], [&] { read_languages[k] = read(rows[k]); });
  return &read_languages[k];
}

} // namespace symreal
