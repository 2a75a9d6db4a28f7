#include "program/build/linking.h"

#include "engine/support/files.h"
#include "engine/support/version.h"
#include "program/build/make_rule.h"
#include "program/build/object_cache.h"

#include <llvm/Support/Program.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>

namespace symreal::program {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::uintmax_t most_kept = std::uintmax_t{8} << 20; // bytes of a cached program

bool has_gold() {
  static bool const has = bool(llvm::sys::findProgramByName("ld.gold"));
  return has;
}

} // namespace

std::string Linking::key(Command const &command) {
  std::string key = fmt::format("linked {}\n{}\n", version, program_stamp("ld.gold"));
  for (char const *name : {"COMPILER_PATH", "GCC_EXEC_PREFIX", "LIBRARY_PATH", "LD_RUN_PATH", "CCC_OVERRIDE_OPTIONS"})
    if (char const *value = std::getenv(name)) key += fmt::format("{}={}\n", name, value);
  key += program_stamp(command.arguments.front()) + "\n";
  for (std::string const &word : command.arguments)
    if (!word.starts_with(workspace_))
      key += (fs::is_regular_file(word) ? file_stamp(word) : word) + "\n";
    else if (fs::is_regular_file(word))
      key += files_.content_id(word) + "\n";
  return content_id(key);
}

// An entry holds the program's content id and the stamps of the linker's further inputs.
bool Linking::take(std::string const &key, std::string const &program) {
  std::optional<std::string> const kept = directory_.find(key);
  if (!kept) return false;
  std::istringstream lines(*kept);
  std::string id, one;
  std::getline(lines, id);
  while (std::getline(lines, one)) {
    std::size_t const path = one.find(' ', one.find(' ') + 1);
    if (path == one.npos || file_stamp(one.substr(path + 1)) != one) return false;
  }
  if (!directory_.take_file(id, program)) return false;
  std::error_code error;
  fs::permissions(program, fs::perms::owner_all, error);
  return !error;
}

void Linking::keep(std::string const &key, std::string const &program, std::string const &rule) {
  std::error_code error;
  Words const read = read_make_rule(text_of_file(rule).value_or(""));
  if (read.empty() || fs::file_size(program, error) > most_kept || error) return;
  std::string const id = content_id("program " + key);
  std::string text = id + "\n";
  for (std::string const &path : read)
    if (!path.starts_with(workspace_)) text += file_stamp(path) + "\n";
  directory_.keep_file(id, program);
  directory_.keep(key, text);
}

// gold takes a third of the time. If it fails, the compiler's own linker links, or reports the error.
Captured Linking::link(Command const &command) {
  bool const is_chosen =
      std::ranges::any_of(command.arguments, [](auto const &word) { return word.starts_with("-fuse-ld="); });
  if (!has_gold() || is_chosen) return capture(command);
  std::string const &program = command.arguments[position_after(command.arguments, "-o")], rule = program + ".d";
  std::string const by_words = may_keep_ ? key(command) : "";
  if (may_keep_ && take(by_words, program)) return {{Ending::exited, 0, 0}, {}};
  Command quick = command;
  quick.arguments.emplace_back("-fuse-ld=gold");
  if (may_keep_) quick.arguments.push_back("-Wl,--dependency-file=" + rule);
  Captured linked = capture(quick);
  if (!linked.outcome.success()) return capture(command);
  if (may_keep_) keep(by_words, program, rule);
  return linked;
}

} // namespace symreal::program
