#include "rewrite/edit/fixes.h"

#include <clang/Tooling/Core/Replacement.h>
#include <clang/Tooling/ReplacementsYaml.h>

namespace symreal::rewrite {

std::string fixes_yaml(std::vector<File> const &files) {
  clang::tooling::TranslationUnitReplacements all;
  for (File const &file : files)
    for (Edit const &edit : file.edits)
      all.Replacements.emplace_back(file.path, static_cast<unsigned>(edit.offset), static_cast<unsigned>(edit.length),
                                    edit.text);
  std::string text;
  llvm::raw_string_ostream stream(text);
  llvm::yaml::Output yaml(stream);
  yaml << all;
  return text;
}

} // namespace symreal::rewrite
