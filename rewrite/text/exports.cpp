#include "rewrite/text/exports.h"

#include "engine/support/text.h"

#include <clang/Tooling/Core/Replacement.h>
#include <clang/Tooling/ReplacementsYaml.h>

#include <filesystem>

namespace symreal::rewrite {
namespace {

std::filesystem::path common_directory(std::vector<File> const &files) {
  std::filesystem::path common = std::filesystem::path(files.front().path).parent_path();
  for (File const &file : files)
    while (file.path.compare(0, common.native().size() + 1, common.native() + "/") != 0 && common.has_relative_path())
      common = common.parent_path();
  return common;
}

} // namespace

std::vector<MirrorFile> mirror(std::vector<File> const &files, std::string const &directory, std::string const &top) {
  std::vector<MirrorFile> all;
  if (files.empty()) return all;
  std::filesystem::path const common = top.empty() ? common_directory(files) : std::filesystem::path(top);
  for (File const &file : files) {
    std::filesystem::path const path = directory / std::filesystem::path(file.path).lexically_relative(common);
    // A byte order mark is one only at the very beginning.
    std::string const mark = file.text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? file.text.substr(0, 3) : "";
    all.push_back(
        {path.string(), mark + "#line 1 " + in_quotes(file.compiled_name) + "\n" + file.text.substr(mark.size())});
  }
  return all;
}

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
