#include "tool/options/language_option.h"

#include "engine/diagnostics/diagnostic.h"
#include "tool/options/options.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace symreal::tool {

namespace fs = std::filesystem;

void LanguageOption::add_to(CLI::App &app, std::string const &usual, std::string others) {
  text = usual;
  others_ = std::move(others);
  std::string names;
  for (Language const &language : symreal::languages())
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", language.name, language.doc);
  app.add_option("--lang", text,
                 "Output languages, separated by commas: " + names + (others_.empty() ? "" : "; or " + others_))
      ->capture_default_str();
}

bool LanguageOption::is_other() const { return ("|" + others_ + "|").find("|" + text + "|") != std::string::npos; }

std::vector<Language const *> LanguageOption::languages() const {
  std::vector<Language const *> found;
  std::string words = others_;
  for (Language const &language : symreal::languages()) words.append(words.empty() ? "" : "|").append(language.name);
  if (is_other()) return found;
  for (std::string_view rest = text;;) {
    std::size_t const end = std::min(rest.find(','), rest.size());
    std::string const name(rest.substr(0, end));
    require_one_of("--lang", name, words);
    found.push_back(find_language(name));
    if (end == rest.size()) return found;
    rest.remove_prefix(end + 1);
  }
}

std::vector<Language const *> all_languages() {
  std::vector<Language const *> all;
  for (Language const &language : symreal::languages()) all.push_back(&language);
  return all;
}

void require_one_language(std::vector<Language const *> const &languages, EmitterOptions const &options) {
  if (languages.size() > 1 && !options.map_file.empty())
    fail(DiagnosticId::bad_option, {}, "--map is the map of one file: ask for one language with --lang");
}

void require_source_name(std::string const &path, std::vector<Language const *> const &languages) {
  std::string const extension = fs::path(path).extension();
  std::vector<std::string_view> known;
  for (Language const *language : languages) known.push_back(language->files.extension);
  if (std::ranges::find(known, extension) == known.end())
    fail(DiagnosticId::bad_option, {},
         fmt::format("the result is a file whose name ends in {}, not '{}'", fmt::join(known, " or "), path));
  if (fs::path(path).filename().string().find_first_of("\"\n\\") != std::string::npos)
    fail(DiagnosticId::bad_option, {}, "an #include cannot name the header beside '" + path + "'");
}

} // namespace symreal::tool
