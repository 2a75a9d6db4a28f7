#include "rewrite/request/request.h"

#include <fnmatch.h>
#include <llvm/ADT/StringExtras.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>
#include <llvm/Support/xxhash.h>

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

std::string content_id(std::string_view text) {
  llvm::XXH128_hash_t const hash = llvm::xxh3_128bits(llvm::arrayRefFromStringRef(llvm::StringRef(text)));
  return llvm::utohexstr(hash.high64, /*LowerCase=*/true, 16) + llvm::utohexstr(hash.low64, /*LowerCase=*/true, 16);
}

std::string real_path(std::string const &name) {
  llvm::SmallString<256> result;
  if (!llvm::sys::fs::real_path(name, result)) return result.str().str();
  llvm::StringRef const directory = llvm::sys::path::parent_path(name);
  if (llvm::sys::fs::real_path(directory.empty() ? "." : directory, result)) return name;
  llvm::sys::path::append(result, llvm::sys::path::filename(name));
  return result.str().str();
}

std::vector<Compilation> compilations_of(Request const &request) {
  std::vector<Compilation> result = request.compilations;
  if (result.empty())
    for (std::string const &source : request.sources) result.push_back({source, {}, request.flags});
  for (Compilation &one : result) one.defines = request.defines;
  return result;
}

std::string real_source(Compilation const &compilation) {
  llvm::SmallString<256> path(compilation.source);
  if (!compilation.directory.empty()) llvm::sys::fs::make_absolute(compilation.directory, path);
  return real_path(path.str().str());
}

std::vector<std::string> type_name_flags(std::string const &type_name) {
  if (type_name == usual_type_name) return {"-include", "symreal/real.h"};
  std::vector<std::string> flags = {"-include", "symreal/macros.h"};
  if (type_name != reserved_type_name) flags.push_back("-D" + type_name + "=" + reserved_type_name);
  return flags;
}

} // namespace symreal::rewrite
