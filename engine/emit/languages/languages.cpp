#include "engine/emit/languages/languages.h"

#include <algorithm>

namespace symreal {

std::span<Language const> languages() {
  static std::vector<Language> const all = [] {
    std::vector<Language> tables;
#define LANGUAGE(its_name, its_doc)                                                                                    \
  tables.push_back(language_##its_name());                                                                             \
  tables.back().name = #its_name;                                                                                      \
  tables.back().doc = its_doc;
#include "engine/emit/languages/languages.def"
#undef LANGUAGE
    return tables;
  }();
  return all;
}

Language const *find_language(std::string_view name) {
  auto const found = std::ranges::find(languages(), name, &Language::name);
  return found == languages().end() ? nullptr : &*found;
}

} // namespace symreal
