// Registry of the files that a command uses, whoever opens them: the tool (support/files.h), Clang, compilers, or the
// programs that it runs. The result depends on the files read, and no output may replace one. All functions are
// thread-safe.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

void note_read(std::string const &path);
// Notes a failed lookup: the file's appearance would change the result.
void note_absent(std::string const &path);
// Notes a file that a program opened with these `flags` of open(2). A file that it writes before reading is its own.
void note_opened(std::string const &path, int flags);
// Notes that this system cannot observe the files that programs open.
void note_unseen();

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

} // namespace symreal::program
