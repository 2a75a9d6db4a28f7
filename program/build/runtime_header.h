// Precompiled version of the runtime header that each rewritten source includes first.
//
// The header is as large as a small program. gcc and clang take a precompiled header if the same compiler made it with
// the same arguments: so there is one for each combination. Directories searched after the system's are ignored, unless
// one has a header of a name that the precompiled one includes; for gcc, so are the user's other directories and the
// program's macros. It is cached like an object (object_cache.h). Making it costs what three sources gain; it is made
// for the third that asks for it, in this run or an earlier one.
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

  // The compilation with the precompiled header instead of the text; nullopt if it is unavailable. Thread-safe. The
  // header itself, which is large, is not read before it is needed.
  std::optional<ObjectCache::Quick> use(Command const &compilation, FilesNow &files);

private:
  struct One {
    std::mutex mutex;
    std::size_t asked = 0;
    bool tried = false;
    std::string path;               // text beside which the precompiled header lies; empty if unavailable
    std::string object;             // key of its cache entry
    bool is_laid = false;           // the header lies at `path`
    std::vector<std::string> names; // names that it includes and some system directory lacks
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
