#include "tool/compiler/link.h"

#include "engine/diagnostics/diagnostic.h"
#include "engine/support/installation.h"
#include "program/build/compile.h"
#include "tool/compiler/link_marks.h"

#include <algorithm>
#include <iostream>

namespace symreal::compiler {
namespace {

bool has(Words const &words, std::initializer_list<std::string_view> wanted) {
  return std::any_of(words.begin(), words.end(), [&](std::string const &word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  });
}

} // namespace

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
