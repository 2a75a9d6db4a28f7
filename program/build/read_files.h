// Registry of the files that a command uses, whoever opens them: the tool (support/files.h), Clang, compilers, or the
// programs that it runs. The result depends on the files read, and no output may replace one. All functions are
// thread-safe.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

void note_read(std::string const &path);

// The name under which this file was read, or written by a program; `path` may be another spelling, a link or a hard
// link.
std::optional<std::string> known_as(std::string const &path);

// Identity of a file for the system; for a file that does not exist yet, its name in the real directory.
std::string identity_of(std::string const &path);

struct ReadFiles {
  std::vector<std::string> read, absent; // absolute paths
  bool are_all = true;
};
ReadFiles files_read();

// Observer of the files that a process and its descendants open: a seccomp filter with a listener holds each open call
// until its path is noted. Works for any program, however it is linked.
class OpenedFiles {
public:
  OpenedFiles();
  ~OpenedFiles();
  OpenedFiles(OpenedFiles const &) = delete;
  OpenedFiles &operator=(OpenedFiles const &) = delete;

  // Installs the filter in the child, just before exec; allocates nothing.
  void install() const noexcept;
  // Serves the filter in the parent, after the child's exec: notes the files in a thread of its own until the last
  // process has ended.
  void serve();

private:
  int ends_[2] = {-1, -1}; // socket pair by which the child passes the listener
};

} // namespace symreal::program
