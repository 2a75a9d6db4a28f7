// The files that a command has to do with, whoever opens them: the tool itself (support/files.h), Clang, the compilers,
// the programs that it runs. No result may take the place of one, and the result depends on those that were read.
// All functions may be called by several threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

void note_read(std::string const &path);
// It was asked for and is not there: its appearance would change the result.
void note_absent(std::string const &path);
// As a program that was run opens it; `flags` as of open(2). What a program writes first and reads then is its own.
void note_opened(std::string const &path, int flags);
// Files that a program opens are not seen on this system.
void note_unseen();

// The name by which a file was read, or written by a program, that this path names as well: by another spelling,
// through a link, or as a hard link.
std::optional<std::string> known_as(std::string const &path);

// A file as the system knows it, or, of one that is still to be made, its name in the real directory.
std::string identity_of(std::string const &path);

struct ReadFiles {
  std::vector<std::string> read, absent; // absolute
  bool are_all = true;
};
ReadFiles files_read();

} // namespace symreal::program
