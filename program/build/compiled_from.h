// Inputs of a compilation: the files that it read, and the places where it looked for a file in vain.
#pragma once

#include "program/build/process.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace symreal::program {

// Current contents of files, each read once a run. Thread-safe.
class FilesNow {
public:
  std::string const &content_id(std::string const &path); // empty if the file does not exist
  bool exists(std::string const &path);

private:
  std::mutex mutex_;
  std::map<std::string, std::string> ids_;
  std::map<std::string, bool> exist_;
};

// Identifier of a text's contents: a hash.
std::string content_id(std::string_view text);

// Inputs of one compilation. Paths below the run's workspace begin with "@" instead.
struct CompiledFrom {
  std::map<std::string, std::string> files; // content id by path
  std::vector<std::string> directories, names;
  std::vector<std::pair<std::size_t, std::size_t>> absent; // indices of a directory and of a name in it

  bool still_holds(FilesNow &now, std::string const &workspace) const;
};

// `files`: files that the compiler has read, as it names them. `messages`: its output under -v. Nullopt if the texts'
// inclusions cannot be determined.
std::optional<CompiledFrom> compiled_from(Command const &compilation, std::vector<std::string> const &files,
                                          std::string_view messages, std::string const &workspace);

std::string to_bytes(CompiledFrom from, std::string object);
// Nullopt if the bytes are malformed.
std::optional<std::pair<CompiledFrom, std::string>> compiled_from_bytes(std::string_view bytes);

} // namespace symreal::program
