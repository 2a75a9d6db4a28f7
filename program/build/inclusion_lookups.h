// Where a compiler may look for what a text includes.
//
// A compiler lists the files that it has read, and not where it has looked for them in vain: a header that comes to lie
// there would be read instead. So each text that it has read is looked through for what it asks to be included, whether
// it is compiled there or not: too many places are looked at rather than too few.
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
  std::vector<std::string> macros; // what `#include MACRO` is made of, if it is compiled and the macro is one
};

// Of #include and __has_include, each once. Nothing where one of them is spelled in another way, or where the text
// depends on the time of the day.
std::optional<Inclusions> inclusions_of(std::string_view text);

// Of __has_include and __has_include_next alone, as far as they are spelled so.
std::vector<Inclusion> questions_of(std::string_view text);

// Does the text define the macro?
bool defines(std::string_view text, std::string_view macro);

// The directories that gcc and clang search, in order, by what they say under -v. Those that are not there count too.
std::vector<std::string> searched_directories(std::string_view messages);

} // namespace symreal::program
