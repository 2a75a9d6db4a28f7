#include "engine/support/installation.h"

#include <filesystem>

namespace symreal {

namespace fs = std::filesystem;

// Path of a file beside an installed tool, wherever the tree was moved to; for a tool in its build tree, that in the
// sources.
static std::string installed_or(char const *installed, char const *built) {
  std::error_code error;
  fs::path const tool = fs::read_symlink("/proc/self/exe", error);
  fs::path const path = (tool.parent_path().parent_path() / "lib/symreal" / installed).lexically_normal();
  return !error && fs::exists(path, error) ? path.string() : built;
}

std::string const &runtime_include() {
  static std::string const path = installed_or("include", SYMREAL_RUNTIME_INCLUDE);
  return path;
}

std::string const &runtime_library() {
  static std::string const path = installed_or("libsymreal_runtime.a", SYMREAL_RUNTIME_LIBRARY);
  return path;
}

std::string const &generating_library() {
  static std::string const path = installed_or("libsymreal_generate.a", SYMREAL_GENERATING_LIBRARY);
  return path;
}

std::string const &recording_plugin() {
  static std::string const path = installed_or("symreal-record-instructions.so", SYMREAL_RECORDING_PLUGIN);
  return path;
}

} // namespace symreal
