#include "engine/support/files.h"

#include "engine/diagnostics/diagnostic.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

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

// Compares piece by piece, in constant memory.
bool holds(std::string const &path, std::string_view text) {
  std::error_code problem;
  if (std::filesystem::file_size(path, problem) != text.size() || problem) return false;
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(std::size_t{1} << 16);
  while (file && !text.empty()) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    std::string_view const read(piece.data(), static_cast<std::size_t>(file.gcount()));
    if (!text.starts_with(read)) return false;
    text.remove_prefix(read.size());
  }
  return text.empty();
}

std::optional<std::string> text_of_file(std::string const &path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || std::filesystem::is_directory(path)) return std::nullopt;
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  return file.bad() ? std::nullopt : std::optional(text.str());
}

static void (*read_watch)(std::string const &path) = nullptr;

void watch_reads(void (*watch)(std::string const &path)) { read_watch = watch; }

std::string read_file(std::string const &path) {
  if (read_watch) read_watch(path);
  errno = 0;
  if (auto text = text_of_file(path)) return *text;
  fail(DiagnosticId::unreadable_file, {path}, "cannot read '" + path + "': " + std::strerror(errno ? errno : EISDIR));
}

bool write_whole(int descriptor, void const *begin, std::size_t size) {
  auto const *next = static_cast<char const *>(begin);
  while (size != 0) {
    ssize_t const written = write(descriptor, next, size);
    if (written < 0 && errno != EINTR) return false;
    if (written <= 0) continue;
    next += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

void write_if_changed(std::string const &path, std::string const &text) {
  if (holds(path, text)) return;
  std::string temporary = path + ".XXXXXX";
  int descriptor = mkstemp(temporary.data());
  auto give_up = [&](int reason) {
    if (descriptor >= 0) unlink(temporary.c_str());
    fail(DiagnosticId::unwritable_output, {path}, "cannot write '" + path + "': " + std::strerror(reason));
  };
  if (descriptor < 0) give_up(errno);
  if (!write_whole(descriptor, text.data(), text.size())) {
    int reason = errno;
    close(descriptor);
    give_up(reason);
  }
  mode_t mask = umask(0); // mkstemp makes private files; the result gets the permissions of any new file
  umask(mask);
  if (fchmod(descriptor, 0666 & ~mask) != 0 || close(descriptor) != 0) give_up(errno);
  if (rename(temporary.c_str(), path.c_str()) != 0) give_up(errno);
}

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
