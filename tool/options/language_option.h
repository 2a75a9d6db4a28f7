// --lang: the languages of the result.
#pragma once

#include "engine/emit/languages/languages.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace symreal::tool {

struct LanguageOption {
  std::string text; // names separated by commas, or a word of the subcommand's own

  // `others`: such words, separated by '|'.
  void add_to(CLI::App &app, std::string const &usual, std::string others = {});
  // Throws bad_option for a name that is in no row of languages.def. Empty for one of the other words.
  std::vector<Language const *> languages() const;

private:
  bool is_other() const;
  std::string others_;
};

std::vector<Language const *> all_languages();

// Fails for options that name one file, where several languages are asked for.
struct EmitterOptions;
void require_one_language(std::vector<Language const *> const &languages, EmitterOptions const &options);

// Fails for a file that none of the languages gives its source.
void require_source_name(std::string const &path, std::vector<Language const *> const &languages);

} // namespace symreal::tool
