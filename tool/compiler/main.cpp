// symreal-c++ and symreal-cc: stand in for a build's compilers and carry it through in symbolic mode.
//
//   command line ──▶ source ──rewrite──▶ overlay ──host's compiler──▶ object, dependencies, preprocessed text
//        ├─────────▶ objects ──host's linker──▶ program that records itself
//        └─────────▶ all else: the host's compiler as it is
#include "engine/diagnostics/diagnostic.h"
#include "engine/support/files.h"
#include "program/build/process.h"
#include "program/build/workspace.h"
#include "rewrite/request/driver_options.h"
#include "rewrite/rewrite.h"
#include "tool/compiler/command_line.h"
#include "tool/compiler/link.h"
#include "tool/compiler/translate.h"
#include "tool/configuration/configuration.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace symreal::compiler {
namespace {

namespace fs = std::filesystem;

fs::path real(fs::path const &name) {
  std::error_code error;
  fs::path const path = fs::weakly_canonical(fs::absolute(name), error);
  return error ? name : path;
}

bool is_below(fs::path const &path, fs::path const &directory) {
  return path.native().starts_with((directory / "").native());
}

bool holds_one(fs::path const &directory, std::initializer_list<char const *> names) {
  std::error_code error;
  return std::any_of(names.begin(), names.end(), [&](char const *name) { return fs::exists(directory / name, error); });
}

fs::path project_of(fs::path const &source) {
  fs::path built = source.parent_path(); // the highest directory that describes a build
  for (fs::path at = built; at.has_relative_path(); at = at.parent_path()) {
    if (holds_one(at, {".symreal.yaml", ".git", ".hg", ".svn"})) return at;
    if (holds_one(at, {"CMakeLists.txt", "meson.build", "configure", "Makefile", "GNUmakefile"})) built = at;
  }
  return built;
}

bool is_probe_directory(std::string const &path) {
  for (char const *part : {"/CMakeFiles/CMakeScratch/", "/CMakeFiles/CMakeTmp/", "/CMakeFiles/_CMakeLTOTest-",
                           "/CompilerIdCXX/", "/CompilerIdC/", "/CMakeFiles/ShowIncludes/", "/meson-private/"})
    if (path.find(part) != path.npos) return true;
  return false;
}

// Roots of a source: $SYMREAL_ROOTS, directories separated by colons, or else the source's project: the nearest parent
// with .symreal.yaml or a repository's top, else the highest that describes a build (CMakeLists.txt, meson.build,
// configure, Makefile), else its own directory. Empty if the source lies outside $SYMREAL_ROOTS.
Words roots_of(std::string const &source) {
  fs::path const path = real(source);
  char const *const given = std::getenv("SYMREAL_ROOTS");
  if (!given || !*given) return {project_of(path).string()};
  Words roots;
  bool inside = false;
  std::istringstream text(given);
  for (std::string root; std::getline(text, root, ':');) {
    if (root.empty()) continue;
    roots.push_back(real(root).string());
    inside |= is_below(path, roots.back());
  }
  return inside ? roots : Words();
}

// Exclusions of the source's .symreal.yaml.
rewrite::Exclusion exclusion_of(std::string const &source) {
  std::string const file = tool::find_configuration(real(source).parent_path().string());
  return file.empty() ? rewrite::Exclusion() : tool::read_configuration(file).exclude;
}

// Is the source a probe by which CMake, Meson or configure tests the compiler? The answers must be those of the numeric
// build.
bool is_probe(std::string const &source) {
  std::error_code error;
  fs::path const here = fs::current_path(error);
  return is_probe_directory((here / source).string()) || is_probe_directory((here / "").string()) ||
         fs::path(source).filename().native().starts_with("conftest.");
}

Words host_compiler(char const *variable, char const *otherwise) {
  char const *const given = std::getenv(variable);
  return program::split_words(given && *given ? given : otherwise);
}

int pass_on(Words words, Words const &arguments) {
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char *> pointers;
  for (std::string &word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  fail(DiagnosticId::compiler_missing, {}, "'" + words[0] + "' cannot be started: " + std::strerror(errno));
}

// Replaces -x and its operand by options without effect, so that other words keep their indices.
void forget_language(Words &words) {
  for (rewrite::DriverOption const &option : rewrite::driver_options(words))
    if (option.about == rewrite::About::language)
      for (std::size_t k = 0; k < option.length; ++k) words[option.word + k] = "-w";
}

enum class Way { as_it_is, preprocessed, symbolic };

// An input and the way it is compiled.
struct Source {
  Input input;
  Way way;
  Words roots; // of a symbolic source
  rewrite::Exclusion exclude = {};
};

Source source_of(Input const &input) {
  std::error_code error;
  bool const is_source =
      input.language != Language::other && input.language != Language::header && fs::is_regular_file(input.name, error);
  if (!is_source || is_probe(input.name)) return {input, Way::as_it_is, {}};
  if (input.language == Language::preprocessed)
    return {input, is_symbolic(read_file(input.name)) ? Way::preprocessed : Way::as_it_is, {}};
  Words roots = roots_of(input.name);
  if (roots.empty()) return {input, Way::as_it_is, {}};
  rewrite::Exclusion exclude = exclusion_of(input.name);
  Way const way = exclude.matches(fs::canonical(input.name).string()) ? Way::as_it_is : Way::symbolic;
  return {input, way, std::move(roots), std::move(exclude)};
}

std::string named_after(std::string const &source, Action action) {
  if (action == Action::preprocess || action == Action::check) return {};
  return fs::path(source).stem().string() + (action == Action::assembly ? ".s" : ".o");
}

class Run {
public:
  Run(Words arguments, bool is_c)
      : arguments_(std::move(arguments)),
        cxx_(host_compiler("SYMREAL_CXX", "c++")),
        own_(is_c ? host_compiler("SYMREAL_CC", "cc") : cxx_),
        line_(parse(arguments_, is_c ? Language::c : Language::cxx)) {
    for (Input const &input : line_.inputs) sources_.push_back(source_of(input));
  }

  int run() {
    bool symbolic = false, header = false;
    for (Source const &source : sources_) {
      symbolic |= source.way != Way::as_it_is;
      header |= source.input.language == Language::header; // a precompiled header: nothing is linked
    }
    if (line_.action == Action::link && !header && !is_probe(".")) return compile_and_link();
    if (!symbolic || line_.action == Action::other || line_.action == Action::link) return pass_on(own_, arguments_);
    bool done = true;
    for (Source const &source : sources_)
      done &= compile(source, line_.action,
                      line_.output.empty() ? named_after(source.input.name, line_.action) : line_.output);
    return done ? 0 : 1;
  }

private:
  bool compile(Source const &source, Action action, std::string const &output) {
    Translation const translation{cxx_, source.input, source.roots, source.exclude, action, output};
    switch (source.way) {
    case Way::symbolic: return translate(translation, line_);
    case Way::preprocessed: return compile_preprocessed(translation, line_);
    case Way::as_it_is: break;
    }
    Words words = own_;
    words.insert(words.end(), line_.flags.begin(), line_.flags.end());
    words.insert(words.end(), {"-c", source.input.name, "-o", output});
    program::Captured const done = program::capture({.arguments = words});
    std::cerr << done.output;
    return done.outcome.success();
  }

  int compile_and_link() {
    std::optional<program::Workspace> workspace;
    Words words = line_.words;
    forget_language(words); // the inputs are objects from here on
    for (Source const &source : sources_) {
      if (source.input.language == Language::other) continue;
      if (!workspace) workspace.emplace(false);
      std::string const object = workspace->file(std::to_string(source.input.word) + ".o");
      if (!compile(source, Action::compile, object)) return 1;
      words[source.input.word] = object;
    }
    return link(cxx_, workspace ? words : arguments_);
  }

  Words const arguments_;
  Words const cxx_, own_;
  CommandLine const line_;
  std::vector<Source> sources_;
};

} // namespace

} // namespace symreal::compiler

int main(int argc, char **argv) {
  try {
    bool const is_c = std::string_view(argv[0]).ends_with("cc");
    return symreal::compiler::Run({argv + 1, argv + argc}, is_c).run();
  } catch (symreal::DiagnosticError const &problem) {
    print(std::cerr, problem.diagnostic());
  } catch (std::exception const &problem) {
    std::fprintf(stderr, "symreal: internal error: %s\n", problem.what());
  }
  return 1;
}
