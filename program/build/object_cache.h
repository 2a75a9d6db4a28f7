// Objects that were compiled before, in earlier runs as well.
//
// A compilation gives the same object when its compiler, its words, the files that it reads and those that it looks for
// in vain are the same: that is the key of an object. Where the latter cannot be told, as where a macro names what is
// included, the preprocessed text stands for them. (The files count besides the text, since debug information has
// columns, which preprocessing does not keep.) The files of a run stand in a workspace of its own; its path does not
// count.
//
// Preprocessing is a tenth of compiling, but that of hundreds of headers. So what was read is kept too, under the
// compiler, the words and the environment (compiled_from.h): while all of that is as it was, the object is the one of
// that time. What is compiled with new words is not preprocessed apart: the compiler tells what it reads.
//
// Of a precompiled header (runtime_header.h), neither text nor files are read: its path, a word, says what it is.
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

  // Runs a compilation, "... -c SOURCE -o OBJECT", or copies the object that it gave before. Several at a time.
  // `files`: of this build, in which they do not change. `quicker`: the same compilation from a precompiled header,
  // which is asked for unless the object is there, and made ready unless that one's is.
  struct Quick {
    Command command;
    std::function<bool()> ready; // false: it cannot be
  };
  using Quicker = std::function<std::optional<Quick>(Command const &)>;
  Captured compile(Command const &compilation, std::string const &workspace, FilesNow &files, Quicker const &quicker);

  // What a compilation that was kept has read, and the key of what it gave.
  using Kept = std::pair<CompiledFrom, std::string>;
  // The same for what is not an object of the program, does not count as one, and is only read. Nothing: it was not
  // compiled before, as far as words and files tell.
  std::optional<Kept> known(Command const &compilation, std::string const &workspace, FilesNow &files);
  // Lays what is kept under the key there; false: it is no longer there, or is damaged.
  bool lay(std::string const &key, std::string const &to) { return directory_->link_file(key, to); }
  // Nothing: the compilation fails, or what it has read cannot be told.
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
  // What is kept under the key of its words, if that still holds.
  std::optional<Kept> kept(std::optional<std::string> const &bytes, std::string const &workspace, FilesNow &files);

  std::shared_ptr<CacheDirectory> directory_;
  std::atomic<std::size_t> compiled_ = 0, reused_ = 0;
};

// A file, or a program that is found as a shell finds it, by path, size and time.
std::string file_stamp(std::string const &path);
std::string program_stamp(std::string const &name);

// Of the words: the position after this one; 0 where it is not among them.
std::size_t position_after(std::vector<std::string> const &words, std::string_view option);

} // namespace symreal::program
