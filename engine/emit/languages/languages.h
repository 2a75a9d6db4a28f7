// The languages of generated code.
#pragma once

#include "engine/emit/language/language.h"
#include "engine/support/asset.h"

#include <span>
#include <string_view>

namespace symreal {

// A row of languages.def.
struct LanguageRow {
  std::string_view name, doc;
};
// All languages, in the order of their rows.
std::span<LanguageRow const> languages();
// The language of this name, or null. It is read from its files when it is asked for first.
Language const *find_language(std::string_view name);

// The files: NAME.toml and, with another extension, its texts.
std::span<Asset const> language_files();

} // namespace symreal
