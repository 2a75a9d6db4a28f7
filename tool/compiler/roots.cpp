#include "tool/compiler/roots.h"

#include "tool/configuration/configuration.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace symreal::compiler {
namespace {

namespace fs = std::filesystem;

fs::path real(fs::path const &name) {
  std::error_code error;
  fs::path const path = fs::weakly_canonical(fs::absolute(name), error);
  return error ? name : path;
}

bool is_below(fs::path const &path, fs::path const &directory) {
  return path.native().starts_with((directory / "").native());
}

bool holds_one(fs::path const &directory, std::initializer_list<char const *> names) {
  std::error_code error;
  return std::any_of(names.begin(), names.end(), [&](char const *name) { return fs::exists(directory / name, error); });
}

fs::path project_of(fs::path const &source) {
  fs::path built = source.parent_path(); // the highest directory that describes a build
  for (fs::path at = built; at.has_relative_path(); at = at.parent_path()) {
    if (holds_one(at, {".symreal.yaml", ".git", ".hg", ".svn"})) return at;
    if (holds_one(at, {"CMakeLists.txt", "meson.build", "configure", "Makefile", "GNUmakefile"})) built = at;
  }
  return built;
}

bool is_probe_directory(std::string const &path) {
  for (char const *part : {"/CMakeFiles/CMakeScratch/", "/CMakeFiles/CMakeTmp/", "/CMakeFiles/_CMakeLTOTest-",
                           "/CompilerIdCXX/", "/CompilerIdC/", "/CMakeFiles/ShowIncludes/", "/meson-private/"})
    if (path.find(part) != path.npos) return true;
  return false;
}

} // namespace

Words roots_of(std::string const &source) {
  fs::path const path = real(source);
  char const *const given = std::getenv("SYMREAL_ROOTS");
  if (!given || !*given) return {project_of(path).string()};
  Words roots;
  bool inside = false;
  std::istringstream text(given);
  for (std::string root; std::getline(text, root, ':');) {
    if (root.empty()) continue;
    roots.push_back(real(root).string());
    inside |= is_below(path, roots.back());
  }
  return inside ? roots : Words();
}

rewrite::Exclusion exclusion_of(std::string const &source) {
  std::string const file = tool::find_configuration(real(source).parent_path().string());
  return file.empty() ? rewrite::Exclusion() : tool::read_configuration(file).exclude;
}

bool is_probe(std::string const &source) {
  std::error_code error;
  fs::path const here = fs::current_path(error);
  return is_probe_directory((here / source).string()) || is_probe_directory((here / "").string()) ||
         fs::path(source).filename().native().starts_with("conftest.");
}

} // namespace symreal::compiler
