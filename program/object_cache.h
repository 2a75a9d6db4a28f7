// Objects that were compiled before, in earlier runs as well.
//
// A compilation gives the same object when its compiler, its words, the files that it reads and its preprocessed text
// are the same. So each compilation is preprocessed first, which takes a tenth of its time: no list of headers of an
// earlier run is believed. (The files count besides the text, since debug information has columns, which preprocessing
// does not keep.) The files of a run stand in a workspace of its own; its path does not count.
#pragma once

#include "program/process.h"

#include <atomic>
#include <cstdint>
#include <string>

namespace symreal::program {

class ObjectCache {
public:
  // In this directory, which is made when it is needed; empty: there is none, and everything is compiled.
  explicit ObjectCache(std::string directory) : directory_(std::move(directory)) {}

  // Runs a compilation, "... -c SOURCE -o OBJECT", or copies the object that it gave before. Several at a time.
  Captured compile(Command const &compilation, std::string const &workspace);

  std::size_t compiled() const { return compiled_; }
  std::size_t reused() const { return reused_; }

  // Removes what was not used for long, until the rest has at most so many bytes.
  void prune(std::uint64_t most_bytes) const;

private:
  std::string directory_;
  std::atomic<std::size_t> compiled_ = 0, reused_ = 0;
};

constexpr std::uint64_t usual_cache_size = std::uint64_t{1} << 30;

// Of this user: $XDG_CACHE_HOME/symreal or ~/.cache/symreal; empty where there is neither.
std::string cache_directory();

struct CacheContents {
  std::size_t objects = 0;
  std::uint64_t bytes = 0;
};
CacheContents cache_contents(std::string const &directory);

// Removes all of it, and says what that was.
CacheContents clear_cache(std::string const &directory);

} // namespace symreal::program
