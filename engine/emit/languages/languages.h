// The languages of generated code.
#pragma once

#include "engine/emit/language/language.h"

#include <span>
#include <string_view>

namespace symreal {

// One function per row of languages.def, which returns the language's table.
#define LANGUAGE(name, doc) Language language_##name();
#include "engine/emit/languages/languages.def"
#undef LANGUAGE

// All languages, in the order of their rows.
std::span<Language const> languages();
// The language of this name, or null.
Language const *find_language(std::string_view name);

} // namespace symreal
