// Parser of a compiler's command line, as far as a compiler wrapper must understand it.
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
  other,      // compiles nothing: -M, --version, -print-search-dirs, ...
};

enum class Language { c, cxx, preprocessed, header, other };

struct Input {
  std::string name;
  Language language;
  std::size_t word; // index in CommandLine::words
};

// Options of the dependency file: -MD, -MMD, and its form.
struct DependencyOptions {
  bool wanted = false;
  bool system = false; // include system headers
  bool phony = false;  // -MP
  std::string file;    // empty: named after the output
  Words targets;       // with make's escapes
};

struct CommandLine {
  Words words; // all words, with response files expanded
  Words flags; // words without inputs, action, output, language and dependencies
  std::vector<Input> inputs;
  Action action = Action::link;
  std::string output;
  DependencyOptions dependencies;
};

// `c_ending`: language of files whose names end in .c.
CommandLine parse(Words const &arguments, Language c_ending);

} // namespace symreal::compiler
