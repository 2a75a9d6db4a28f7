#include "support/diff.h"

#include "diagnostics/diagnostic.h"
#include "support/files.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

namespace symreal {
namespace {

std::string shell_quoted(std::string const &text) {
  std::string result = "'";
  for (char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

struct Directory {
  Directory() {
    char name[] = "/tmp/symreal-diff-XXXXXX";
    if (!mkdtemp(name)) fail(DiagnosticId::unwritable_output, {"/tmp"}, "no temporary directory can be made");
    path = name;
  }
  ~Directory() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Directory(Directory const &) = delete;
  Directory &operator=(Directory const &) = delete;
  std::string path;
};

} // namespace

std::string unified_diff(std::string const &file, std::string const &before, std::string const &after) {
  if (before == after) return {};
  Directory const directory;
  write_if_changed(directory.path + "/before", before);
  write_if_changed(directory.path + "/after", after);
  // A tab says where a name with blanks ends.
  std::string const name = file + (file.find(' ') == std::string::npos ? "" : "\t");
  std::string const command = "diff -u --label " + shell_quoted("a/" + name) + " --label " + shell_quoted("b/" + name) +
                              " " + directory.path + "/before " + directory.path + "/after";
  std::string text;
  FILE *const stream = popen(command.c_str(), "r");
  if (!stream) fail(DiagnosticId::unreadable_file, {file}, "the program diff cannot be started");
  char buffer[4096];
  while (std::size_t const count = std::fread(buffer, 1, sizeof buffer, stream)) text.append(buffer, count);
  int const status = pclose(stream);
  if (status == -1 || text.empty()) fail(DiagnosticId::unreadable_file, {file}, "the program diff failed");
  return text;
}

} // namespace symreal
