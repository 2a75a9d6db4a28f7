// A directory of files that are kept from run to run, each under a key that says all that it was made from.
#pragma once

#include "rewrite/rewrite.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace symreal::program {

// Several threads and processes may use one directory: an entry is there as a whole or not at all. Each carries a hash
// of its content, which is compared whenever it is read; one that is damaged, or that is anything but a regular file of
// this user, is told of and not found.
class CacheDirectory : public rewrite::KeptTexts {
public:
  // The directory is made when it is needed; empty: there is none, and nothing is kept or found.
  // In the end, if something was added and no run has done so in the last minute, what was not used for long is
  // removed, until the rest has at most so many bytes.
  // `damaged` is called with the path of what is damaged, by several threads.
  explicit CacheDirectory(std::string path, std::function<void(std::string const &)> damaged = {},
                          std::uint64_t most_bytes = std::uint64_t{2} << 30)
      : path_(std::move(path)),
        damaged_(std::move(damaged)),
        most_bytes_(most_bytes) {}
  ~CacheDirectory() override;
  CacheDirectory(CacheDirectory const &) = delete;
  CacheDirectory &operator=(CacheDirectory const &) = delete;

  bool exists() const { return !path_.empty(); }

  // Texts.
  std::optional<std::string> find(std::string const &key) override;
  void keep(std::string const &key, std::string const &text) override;

  // Copies the file that is kept under the key; false: there is none.
  bool take_file(std::string const &key, std::string const &to);
  // The same for what is only read, and need not be there as long as `to` is: it is not copied.
  bool link_file(std::string const &key, std::string const &to);
  void keep_file(std::string const &key, std::string const &file);

private:
  std::string entry(std::string const &key, char const *kind) const;
  void tell_damaged(std::string const &entry) const;
  std::string temporary(); // a path at which an entry can be written
  bool place(std::string const &temporary, bool is_written, std::string const &entry);
  // The path of the file that is kept under the key, if it has the content that it had. `use`: is called with each
  // piece.
  template <class Use> std::optional<std::string> find_file(std::string const &key, Use use);

  std::string path_;
  std::function<void(std::string const &)> damaged_;
  std::uint64_t most_bytes_;
  std::atomic<std::size_t> added_ = 0;
};

// Of this user: $XDG_CACHE_HOME/symreal or ~/.cache/symreal; empty where there is neither.
std::string usual_cache_directory();

struct CacheContents {
  std::size_t files = 0, texts = 0;
  std::uint64_t bytes = 0;
};
CacheContents cache_contents(std::string const &directory);

// Removes all of it, and says what that was.
CacheContents clear_cache(std::string const &directory);

} // namespace symreal::program
