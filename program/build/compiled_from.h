// Inputs of a compilation: the files that it read, and the places where it looked for a file in vain.
//
// A compiler lists the files that it read, but not the places where a lookup failed; a header that appears there later
// would be read instead. So all inclusions in each text are collected, compiled or not: an overapproximation.
#pragma once

#include "program/build/process.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
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

struct Inclusion {
  std::string name;
  bool quoted; // "name" rather than <name>: looked for beside the text first
  auto operator<=>(Inclusion const &) const = default;
};

struct Inclusions {
  std::vector<Inclusion> names;
  std::vector<std::string> macros; // macros of `#include MACRO` directives
};

// Names in #include and __has_include, without duplicates. Nullopt if one is spelled otherwise or the text depends on
// the date or time.
std::optional<Inclusions> inclusions_of(std::string_view text);

// Names in __has_include and __has_include_next alone; other spellings are skipped.
std::vector<Inclusion> questions_of(std::string_view text);

// Does the text define the macro?
bool defines(std::string_view text, std::string_view macro);

// Search directories of gcc or clang in order, parsed from their output under -v; includes nonexistent ones.
std::vector<std::string> searched_directories(std::string_view messages);

} // namespace symreal::program
