// A cache directory that persists across runs: each entry is kept under a key derived from all its inputs.
#pragma once

#include "rewrite/rewrite.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace symreal::program {

// Threads and processes may share a directory: an entry is present as a whole or absent. Each carries a hash of its
// content, checked at every read; a damaged entry, or one that is not a regular file of this user, is reported and
// treated as absent.
class CacheDirectory : public rewrite::KeptTexts {
public:
  // The directory is created on demand; an empty path disables the cache. The destructor removes entries that have not
  // been used for long, down to `most_bytes`, if something was added and no run has pruned within the last minute.
  // Several threads call `damaged` with the paths of damaged entries.
  explicit CacheDirectory(std::string path, std::function<void(std::string const &)> damaged = {},
                          std::uint64_t most_bytes = std::uint64_t{5} << 30)
      : path_(std::move(path)),
        damaged_(std::move(damaged)),
        most_bytes_(most_bytes) {}
  ~CacheDirectory() override;
  CacheDirectory(CacheDirectory const &) = delete;
  CacheDirectory &operator=(CacheDirectory const &) = delete;

  bool exists() const { return !path_.empty(); }

  // Text entries.
  std::optional<std::string> find(std::string const &key) override;
  void keep(std::string const &key, std::string const &text) override;

  // Copies the file kept under the key; false if the key has no entry.
  bool take_file(std::string const &key, std::string const &to);
  // Links `to` to the file instead of copying it; for files that are only read and may vanish with their entry.
  bool link_file(std::string const &key, std::string const &to);
  void keep_file(std::string const &key, std::string const &file);

private:
  std::string entry(std::string const &key, char const *kind) const;
  void tell_damaged(std::string const &entry) const;
  std::string temporary(); // a path to write an entry at
  bool place(std::string const &temporary, bool is_written, std::string const &entry);
  // Path of the file kept under the key, if its content is intact; calls `use` with each piece.
  template <class Use> std::optional<std::string> find_file(std::string const &key, Use use);

  std::string path_;
  std::function<void(std::string const &)> damaged_;
  std::uint64_t most_bytes_;
  std::atomic<std::size_t> added_ = 0;
};

// Cache directory of this user: $XDG_CACHE_HOME/symreal or ~/.cache/symreal; empty without a home directory.
std::string usual_cache_directory();

struct CacheContents {
  std::size_t files = 0, texts = 0;
  std::uint64_t bytes = 0;
};
CacheContents cache_contents(std::string const &directory);

// Removes all entries and returns what was removed.
CacheContents clear_cache(std::string const &directory);

} // namespace symreal::program
