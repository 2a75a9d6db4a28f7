// Linker with a cache of programs that earlier runs have linked.
//
// Linking takes as long as compiling a small source. A link is determined by the linker, its arguments and environment,
// the objects and its other inputs. Objects count by content; the runtime and system libraries, as the linker names
// them, by path, size and time, as the compiler does. Links with the user's own linker arguments are always run; large
// programs are not cached.
#pragma once

#include "program/build/cache_directory.h"
#include "program/build/compiled_from.h"
#include "program/build/process.h"

#include <string>

namespace symreal::program {

class Linking {
public:
  // `files`: contents of files, constant during this build. `may_keep`: the user has no linker arguments of their own.
  Linking(CacheDirectory &directory, std::string workspace, FilesNow &files, bool may_keep)
      : directory_(directory),
        workspace_(std::move(workspace)),
        files_(files),
        may_keep_(may_keep && directory.exists()) {}

  // Runs "... OBJECT... LIBRARY -o PROGRAM", or copies the program that it gave before. Thread-safe.
  Captured link(Command const &command);

private:
  std::string key(Command const &command);
  bool take(std::string const &key, std::string const &program);
  void keep(std::string const &key, std::string const &program, std::string const &rule);

  CacheDirectory &directory_;
  std::string const workspace_;
  FilesNow &files_;
  bool const may_keep_;
};

} // namespace symreal::program
