#include "tool/compiler/command_line.h"

#include "engine/support/files.h"
#include "program/build/make_rule.h"
#include "program/build/process.h"
#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <filesystem>

namespace symreal::compiler {

using rewrite::About;
using rewrite::DriverOption;

namespace {

bool is_among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

Language language(std::string const &name, std::string const &named, Language c_ending) {
  if (named == "c") return Language::c;
  if (named == "c++") return Language::cxx;
  if (named == "cpp-output" || named == "c++-cpp-output") return Language::preprocessed;
  if (named == "c-header" || named == "c++-header") return Language::header;
  if (!named.empty()) return Language::other;
  std::string const ending = std::filesystem::path(name).extension();
  if (ending == ".c") return c_ending;
  if (is_among(ending, {".cc", ".cp", ".cpp", ".cxx", ".c++", ".C", ".CC", ".CPP", ".CXX"})) return Language::cxx;
  if (is_among(ending, {".h", ".hh", ".hpp", ".hxx", ".H"})) return Language::header;
  if (is_among(ending, {".i", ".ii"})) return Language::preprocessed;
  return Language::other;
}

Words expanded(Words const &arguments, unsigned depth = 0) {
  Words words;
  for (std::string const &word : arguments) {
    std::error_code error;
    bool const is_file =
        word.size() > 1 && word[0] == '@' && depth < 16 && std::filesystem::is_regular_file(word.substr(1), error);
    Words const inner = is_file ? expanded(program::split_words(read_file(word.substr(1))), depth + 1) : Words{word};
    words.insert(words.end(), inner.begin(), inner.end());
  }
  return words;
}

// Is this a precompiled header that CMake passes to clang? It is useless, since it was made before rewriting; the
// header itself is named as well.
bool is_compiled_ahead(DriverOption const &option, DriverOption const &next) {
  return option.name == "-Xclang" && option.value.starts_with("-include") && next.name == "-Xclang";
}

class Parser {
public:
  Parser(Words words, Language c_ending) : c_ending_(c_ending) { line_.words = std::move(words); }

  CommandLine parse() {
    std::vector<DriverOption> const options = rewrite::driver_options(line_.words);
    for (std::size_t k = 0; k < options.size(); ++k) {
      DriverOption const &option = options[k];
      if (option.about == About::input)
        line_.inputs.push_back({option.value, language(option.value, language_, c_ending_), option.word});
      else if (k + 1 < options.size() && is_compiled_ahead(option, options[k + 1])) {
        if (option.value == "-include") line_.flags.insert(line_.flags.end(), {"-include", options[k + 1].value});
        ++k;
      } else if (!action(option) && !output(option) && !dependencies(option))
        rewrite::append(line_.flags, option, line_.words);
    }
    if (line_.inputs.empty()) line_.action = Action::other; // -v, or an error that the compiler reports itself
    return std::move(line_);
  }

private:
  // Records an action; the one that stops earliest counts.
  void stop_at(Action action) {
    if (line_.action == Action::other) return;
    line_.action = line_.action == Action::link ? action : std::max(line_.action, action);
  }

  bool action(DriverOption const &option) {
    if (option.name == "-c")
      stop_at(Action::compile);
    else if (option.name == "-S")
      stop_at(Action::assembly);
    else if (option.name == "-E")
      stop_at(Action::preprocess);
    else if (option.name == "-fsyntax-only")
      stop_at(Action::check);
    else if (option.about == About::question)
      line_.action = Action::other;
    else
      return false;
    return true;
  }

  bool output(DriverOption const &option) {
    if (option.about == About::output) line_.output = option.value;
    if (option.about == About::language) language_ = option.value == "none" ? "" : option.value;
    return option.about == About::output || option.about == About::language;
  }

  bool dependencies(DriverOption const &given) {
    DependencyOptions &options = line_.dependencies;
    std::string const &word = line_.words[given.word];
    if (given.name == "-MD" || given.name == "-MMD") {
      options.wanted = true;
      options.system = given.name == "-MD";
    } else if (given.name == "-MP") {
      options.phony = true;
    } else if (given.name == "-MF") {
      options.file = given.value;
    } else if (given.name == "-MT" || given.name == "-MQ") {
      options.targets.push_back(given.name == "-MQ" ? program::make_escaped(given.value) : given.value);
    } else if (word.starts_with("-Wp,-MD,") || word.starts_with("-Wp,-MMD,")) {
      options.wanted = true;
      options.system = word.starts_with("-Wp,-MD,");
      options.file = word.substr(word.find(',', 4) + 1);
    } else {
      return false;
    }
    return true;
  }

  CommandLine line_;
  std::string language_; // argument of -x
  Language const c_ending_;
};

} // namespace

CommandLine parse(Words const &arguments, Language c_ending) { return Parser(expanded(arguments), c_ending).parse(); }

} // namespace symreal::compiler
