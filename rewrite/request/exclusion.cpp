#include "rewrite/request/request.h"

#include <fnmatch.h>

#include <filesystem>

namespace symreal::rewrite {
namespace {

using Names = std::vector<std::string>;

Names names_of(std::string const &path) {
  Names names;
  for (std::filesystem::path const &one : std::filesystem::path(path))
    if (!one.empty() && one != ".") names.push_back(one.string());
  return names;
}

// Whether the pattern matches the path, or a directory above it.
bool matches_from(Names const &pattern, std::size_t p, Names const &path, std::size_t at) {
  if (p == pattern.size()) return true;
  if (pattern[p] == "**") {
    if (p + 1 == pattern.size()) return at < path.size();
    for (std::size_t skipped = at; skipped < path.size(); ++skipped)
      if (matches_from(pattern, p + 1, path, skipped)) return true;
    return false;
  }
  return at < path.size() && fnmatch(pattern[p].c_str(), path[at].c_str(), 0) == 0 &&
         matches_from(pattern, p + 1, path, at + 1);
}

} // namespace

bool Exclusion::matches(std::string const &real_path) const {
  if (patterns.empty()) return false;
  std::string const below = directory.ends_with('/') ? directory : directory + "/";
  if (!real_path.starts_with(below)) return false;
  Names const path = names_of(real_path.substr(below.size()));
  for (std::string const &pattern : patterns) {
    Names wanted = names_of(pattern);
    if (wanted.size() == 1) wanted.insert(wanted.begin(), "**");
    if (!wanted.empty() && matches_from(wanted, 0, path, 0)) return true;
  }
  return false;
}

} // namespace symreal::rewrite
