// Caches of compiled objects and of linked programs that persist across runs.
//
// The key of an object covers the compiler, its arguments, the files that it reads and the failed lookups. If the
// lookups cannot be determined, e.g. because a macro names an included file, the preprocessed text replaces them.
// (Files count besides the text, since debug information has columns, which preprocessing drops.) Each run's files lie
// in a workspace of its own, whose path does not count.
//
// Preprocessing costs a tenth of compiling, or more with hundreds of headers. So the inputs are cached too, under
// compiler, arguments and environment (compiled_from.h): while they are unchanged, so is the object. New arguments need
// no separate preprocessing: the compiler reports its inputs while compiling.
//
// A precompiled header (runtime_header.h) is identified by its path, an argument; its text and files do not count.
#pragma once

#include "program/build/cache_directory.h"
#include "program/build/compiled_from.h"
#include "program/build/process.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

class ObjectCache {
public:
  explicit ObjectCache(std::shared_ptr<CacheDirectory> directory) : directory_(std::move(directory)) {}

  // Runs "... -c SOURCE -o OBJECT", or copies the object that it gave before. Thread-safe. `files`: contents of files,
  // constant during this build. `quicker`: gives the same compilation with a precompiled header; consulted unless the
  // object is cached, and the header is made ready unless that compilation's object is.
  struct Quick {
    Command command;
    std::function<bool()> ready; // false if the header is unavailable
  };
  using Quicker = std::function<std::optional<Quick>(Command const &)>;
  Captured compile(Command const &compilation, std::string const &workspace, FilesNow &files, Quicker const &quicker);

  // Inputs of a cached compilation, and the key of its object.
  using Kept = std::pair<CompiledFrom, std::string>;
  // Looks up an auxiliary file, such as a precompiled header, which is only read and not counted as an object. Nullopt
  // if arguments and files match no earlier compilation.
  std::optional<Kept> known(Command const &compilation, std::string const &workspace, FilesNow &files);
  // Links the file kept under the key to `to`; false if the entry is gone or damaged.
  bool lay(std::string const &key, std::string const &to) { return directory_->link_file(key, to); }
  // Compiles and caches the file. Nullopt if compilation fails or its inputs cannot be determined.
  std::optional<Kept> make(Command const &compilation, std::string const &workspace, FilesNow &files);

  std::size_t compiled() const { return compiled_; }
  std::size_t reused() const { return reused_; }

  CacheDirectory &directory() { return *directory_; }

private:
  struct Search;
  Search search_by_words(Command const &compilation, std::string const &workspace, FilesNow &files);
  Captured compile_first(Search &search, Command const &compilation, std::string const &workspace);
  void search_by_text(Search &search, Command const &compilation, std::string const &workspace);
  void keep(Search const &search, std::string const &workspace);
  // The entry under the arguments' key, if its inputs are unchanged.
  std::optional<Kept> kept(std::optional<std::string> const &bytes, std::string const &workspace, FilesNow &files);

  std::shared_ptr<CacheDirectory> directory_;
  std::atomic<std::size_t> compiled_ = 0, reused_ = 0;
};

// Linker with a cache of programs that earlier runs have linked.
//
// Linking takes as long as compiling a small source. A link is determined by the linker, its arguments and environment,
// the objects and its other inputs. Objects count by content; the runtime and system libraries, as the linker names
// them, by path, size and time, as the compiler does. Links with the user's own linker arguments are always run; large
// programs are not cached.
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

// Position after the word `option`; 0 if it is absent or last.
std::size_t position_after(std::vector<std::string> const &words, std::string_view option);

} // namespace symreal::program
