#include "engine/support/diff.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"

#include <cstdio>
#include <sys/mman.h>
#include <unistd.h>

namespace symreal {
namespace {

std::string shell_quoted(std::string const &text) {
  std::string result = "'";
  for (char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

// A text in memory, which a child process reads as a file; it has no name in any directory.
class TextInMemory {
public:
  explicit TextInMemory(std::string const &text) : descriptor_(memfd_create("text", 0)) {
    if (descriptor_ < 0 || !write_whole(descriptor_, text.data(), text.size()))
      fail(DiagnosticId::unwritable_output, {}, "no text can be handed to the program diff");
  }
  ~TextInMemory() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  TextInMemory(TextInMemory const &) = delete;
  TextInMemory &operator=(TextInMemory const &) = delete;
  std::string path() const { return "/dev/fd/" + std::to_string(descriptor_); }

private:
  int descriptor_;
};

} // namespace

std::string unified_diff(std::string const &file, std::string const &before, std::string const &after) {
  if (before == after) return {};
  TextInMemory const old_text(before), new_text(after);
  // A tab marks the end of a name with blanks.
  std::string const name = file + (file.find(' ') == std::string::npos ? "" : "\t");
  std::string const command = "diff -u --label " + shell_quoted("a/" + name) + " --label " + shell_quoted("b/" + name) +
                              " " + old_text.path() + " " + new_text.path();
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
