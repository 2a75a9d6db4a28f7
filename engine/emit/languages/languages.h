// The languages of generated code.
#pragma once

#include "engine/emit/language/language.h"

#include <span>
#include <string_view>

namespace symreal {

// A table for each row of languages.def.
#define LANGUAGE(name, doc) Language language_##name();
#include "engine/emit/languages/languages.def"
#undef LANGUAGE

// All of them, in the order of their rows.
std::span<Language const> languages();
// The one of this name, or null.
Language const *find_language(std::string_view name);

} // namespace symreal
