// --lang: output languages.
#pragma once

#include "engine/emit/languages/languages.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct LanguageOption {
  std::string text; // names separated by commas, or a special word of the subcommand

  // `others`: special words, separated by '|'.
  void add_to(CLI::App &app, std::string const &usual, std::string others = {});
  // Selected languages; empty for a special word. Throws bad_option for a name that is in no row of languages.def.
  std::vector<Language const *> languages() const;

private:
  bool is_other() const;
  std::string others_;
};

std::vector<Language const *> all_languages();

// Fails for options that name one file if several languages are requested.
struct EmitterOptions;
void require_one_language(std::vector<Language const *> const &languages, EmitterOptions const &options);

// Fails for a file whose extension belongs to none of the languages.
void require_source_name(std::string const &path, std::vector<Language const *> const &languages);

} // namespace symreal::tool
