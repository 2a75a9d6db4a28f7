#include "tool/compiler/link.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/installation.h"
#include "engine/support/text.h"
#include "program/build/compile.h"
#include "rewrite/text/source_text.h"

#include <algorithm>
#include <cstdlib>
#include <cxxabi.h>
#include <iostream>
#include <memory>
#include <set>

namespace symreal::compiler {
namespace {

constexpr std::string_view prefix = "symreal_mode_";

std::string mark(std::string const &mangled) {
  std::string name(prefix);
  for (char c : mangled)
    name += rewrite::is_word(c) ? std::string(1, c) : "_x" + std::to_string(static_cast<unsigned char>(c)) + "_";
  return name;
}

std::string demangled(std::string const &name) {
  int status = 0;
  std::unique_ptr<char, void (*)(void *)> const text(abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status),
                                                     std::free);
  return status == 0 && text ? text.get() : name;
}

// Functions whose marks are undefined, parsed from the linker's messages.
std::set<std::string> missing_marks(std::string const &linker_output) {
  std::set<std::string> functions;
  for (std::size_t at = 0; (at = linker_output.find(prefix, at)) != linker_output.npos;) {
    at += prefix.size();
    std::size_t end = at;
    while (end < linker_output.size() && rewrite::is_word(linker_output[end])) ++end;
    functions.insert(demangled(linker_output.substr(at, end - at)));
  }
  return functions;
}

bool has(Words const &words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](std::string const &word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

} // namespace

std::string link_marks(rewrite::Result const &rewritten) {
  std::string text = "\n";
  for (std::string const &mangled : rewritten.definitions)
    text += "extern \"C\" __attribute__((weak, visibility(\"default\"))) char const " + mark(mangled) + " = 0;\n";
  for (rewrite::Boundary const &boundary : rewritten.boundaries) {
    std::string const name = mark(boundary.mangled);
    // The #line directive makes the linker name the place of the use.
    text += "extern \"C\" char const " + name + ";\n#line " + std::to_string(boundary.use.line) + " " +
            in_quotes(boundary.use.file) + "\n__attribute__((used)) static char const *const symreal_needs_" + name +
            " = &" + name + ";\n";
  }
  return text;
}

int link(Words const &compiler, Words words) {
  bool const is_library = has(words, {"-shared"});
  bool const is_relocatable = has(words, {"-r", "-Wl,-r"});
  words.insert(words.begin(), compiler.begin(), compiler.end());
  if (!is_relocatable) {
    if (!is_library && !program::brings_allocator(words)) words.emplace_back("-Wl,-u,symreal_heap_hooks");
    words.insert(words.end(), {"-x", "none", generating_library()});
  }
  program::Captured const done = program::capture({.arguments = words});
  std::cerr << done.output;
  if (done.outcome.success()) return 0;
  if (done.outcome.ending == program::Ending::not_started)
    print(std::cerr, {DiagnosticId::compiler_missing, {}, "'" + words[0] + "' cannot be started"});
  for (std::string const &function : missing_marks(done.output))
    print(std::cerr,
          {DiagnosticId::boundary_function, {}, "'" + function + "' uses double but is not defined in symbolic mode"});
  return done.outcome.ending == program::Ending::exited ? done.outcome.status : 1;
}

} // namespace symreal::compiler
