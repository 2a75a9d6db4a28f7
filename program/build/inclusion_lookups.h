// Include lookups of a text: the names and directories that a compiler may search.
//
// A compiler lists the files that it read, but not the places where a lookup failed; a header that appears there later
// would be read instead. So all inclusions in each text are collected, compiled or not: an overapproximation.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace symreal::program {

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
