// Programs that are linked, or that an earlier run has linked.
//
// Linking takes as long as compiling a small source. A link gives the same program when the linker, its words and
// environment, the objects and what else it reads are the same. Objects count by their contents; the runtime and the
// system's libraries, which the linker names, by path, size and time, as the compiler does. Where the user's own words
// go to the linker, it runs each time; large programs are not kept.
#pragma once

#include "program/build/cache_directory.h"
#include "program/build/compiled_from.h"
#include "program/build/process.h"

#include <string>

namespace symreal::program {

class Linking {
public:
  // `files`: of this build, in which they do not change. `may_keep`: no words of the user's are among those of the
  // links.
  Linking(CacheDirectory &directory, std::string workspace, FilesNow &files, bool may_keep)
      : directory_(directory),
        workspace_(std::move(workspace)),
        files_(files),
        may_keep_(may_keep && directory.exists()) {}

  // Runs "... OBJECT... LIBRARY -o PROGRAM", or copies the program that it gave before. Several threads.
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
