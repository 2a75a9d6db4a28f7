// The header of the runtime that each rewritten source includes first, precompiled.
//
// It is as large as a small program. gcc and clang take a precompiled header in its place if it was made by the same
// compiler with the same words: so there is one for each of these. Directories that are searched behind the system's do
// not count, unless one of them has a header by a name that the precompiled one asks for; nor, for gcc, do other
// directories of the user's and the program's macros. It is kept like an object (object_cache.h), made from what it is
// made from. Making it costs as much as three sources gain; it is made for the third that asks for it, in this run or
// an earlier one.
#pragma once

#include "program/build/object_cache.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

class RuntimeHeader {
public:
  RuntimeHeader(ObjectCache &objects, CacheDirectory &directory, std::string workspace)
      : objects_(objects),
        directory_(directory),
        workspace_(std::move(workspace)) {}

  // The compilation with the precompiled header instead of the text; nothing where there is none. Several threads. The
  // header itself, which is large, is not looked at before it is needed.
  std::optional<ObjectCache::Quick> use(Command const &compilation, FilesNow &files);

private:
  struct One {
    std::mutex mutex;
    std::size_t asked = 0;
    bool tried = false;
    std::string path;               // of the text beside which the precompiled header lies; empty: there is none
    std::string object;             // what it is kept under
    bool is_laid = false;           // it lies there
    std::vector<std::string> names; // that it asks for; some directory of the system's has not got them
  };
  void make(One &one, Command const &compilation, std::string const &key, FilesNow &files);
  bool lay(One &one, Command const &compilation, std::string const &key, FilesNow &files);
  static bool may_read(One const &one, std::vector<std::string> const &directories, std::string const &base,
                       FilesNow &files);

  ObjectCache &objects_;
  CacheDirectory &directory_;
  std::string const workspace_;
  std::mutex mutex_;
  std::map<std::string, One> all_;
};

} // namespace symreal::program
