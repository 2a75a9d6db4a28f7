// A compiler's command line, as far as what stands in front of the compiler must understand it.
#pragma once

#include <string>
#include <vector>

namespace symreal::compiler {

using Words = std::vector<std::string>;

enum class Action {
  link,
  compile,    // -c
  assembly,   // -S
  preprocess, // -E
  check,      // -fsyntax-only
  other,      // nothing is compiled: -M, --version, -print-search-dirs, ...
};

enum class Language { c, cxx, preprocessed, header, other };

struct Input {
  std::string name;
  Language language;
  std::size_t word; // where it stands in CommandLine::words
};

// -MD and -MMD, and how the file is to look.
struct DependencyOptions {
  bool wanted = false;
  bool system = false; // headers of the system too
  bool phony = false;  // -MP
  std::string file;    // empty: named after the output
  Words targets;       // with make's escapes
};

struct CommandLine {
  Words words; // all of it, response files read
  Words flags; // without inputs, action, output, language and dependencies
  std::vector<Input> inputs;
  Action action = Action::link;
  std::string output;
  DependencyOptions dependencies;
};

// `c_ending` is the language of a file whose name ends in .c.
CommandLine parse(Words const &arguments, Language c_ending);

} // namespace symreal::compiler
