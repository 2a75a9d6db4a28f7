#include "rewrite/request/request.h"

#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>

namespace symreal::rewrite {

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
