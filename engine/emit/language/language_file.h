// A language from its files: a table (toml.h) with the keys of fields.def, and texts in the language itself, which an
// editor shows as such. Lines that begin as its comments do, with an @, divide the texts:
//
//   // @text module.main      the text of a key
//   // @helper erf            a helper of this name
//   // @declaration c_sin     a helper that precedes the contents of the module
//   // @helpers               a helper of each line, which begins with its name; likewise @declarations
//   // @like c_sin c_cos c_tan   the helper c_sin again, with cos for sin, and with tan
//
// Lines before the first of them are a comment, and so is one empty line before each.
#pragma once

#include "engine/emit/language/language.h"

#include <variant>

namespace symreal {

struct LanguageFile {
  std::string_view name, text;
};

// A part that only code can print, and the name by which a table asks for it.
struct NamedCode {
  std::string_view name;
  std::variant<Part, WriteCall, WriteVariable> code;
};

using FindLanguage = Language const *(*)(std::string_view name);

// The language of the files; `find_language` gives one that it starts from (like = "c"). A fault of theirs, such as a
// key that does not exist or a place that a pattern does not have, is an exception with file and line.
Language read_language(LanguageFile const &table, LanguageFile const &texts, std::span<NamedCode const> code,
                       FindLanguage find_language = nullptr);

} // namespace symreal
