// What a compilation has read, and where it may have looked for it in vain.
#pragma once

#include "program/build/process.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// As the files are now: each is read once in a run. Several threads.
class FilesNow {
public:
  std::string const &content_id(std::string const &path); // empty: there is no such file
  bool exists(std::string const &path);

private:
  std::mutex mutex_;
  std::map<std::string, std::string> ids_;
  std::map<std::string, bool> exist_;
};

// What the contents of a text are known by.
std::string content_id(std::string_view text);

// Paths below the workspace of a run begin with "@" instead.
struct CompiledFrom {
  std::map<std::string, std::string> files; // by path: the id of the contents
  std::vector<std::string> directories, names;
  std::vector<std::pair<std::size_t, std::size_t>> absent; // a name in a directory, each by its number

  bool still_holds(FilesNow &now, std::string const &workspace) const;
};

// `files`: those that the compiler has read, as it names them. `messages`: what it says under -v. Nothing where it
// cannot be told what the texts include.
std::optional<CompiledFrom> compiled_from(Command const &compilation, std::vector<std::string> const &files,
                                          std::string_view messages, std::string const &workspace);

std::string to_bytes(CompiledFrom from, std::string object);
// Nothing where the bytes are not those.
std::optional<std::pair<CompiledFrom, std::string>> compiled_from_bytes(std::string_view bytes);

} // namespace symreal::program
