#include "program/build/symbolic_check.h"

#include "engine/support/parallel.h"
#include "program/build/c_macros.h"
#include "program/build/compiler_errors.h"

#include <algorithm>
#include <optional>
#include <thread>

namespace symreal::program {

std::vector<Diagnostic> symbolic_check(BuildRequest request, rewrite::Result rewritten) {
  for (rewrite::File &file : rewritten.files) file.compiled_name = file.display_path;
  Workspace const workspace(false);
  request.type_name = rewritten.type_name;
  CSources c =
      as_in_c(rewritten, request.sources, {request.compiler}, {request.c_compiler}, request.type_name, workspace);
  request.source_flags = std::move(c.flags);
  Overlay const overlay(rewritten, workspace.directory("overlay"), std::move(c.sources));

  std::vector<std::optional<Diagnostic>> found(request.sources.size());
  in_parallel(found.size(), std::thread::hardware_concurrency(), [&](std::size_t k) {
    rewrite::Compilation const &source = request.sources[k];
    std::vector<std::string> words = rewritten_compilation(request, Variant::symbolic, overlay, source, "/dev/null");
    std::replace(words.begin(), words.end(), std::string("-c"), std::string("-fsyntax-only"));
    Captured const result = capture(compiler_run(words, source.directory));
    if (!result.outcome.success()) found[k] = compiler_failure(words, result, overlay);
  });
  std::vector<Diagnostic> diagnostics;
  for (std::optional<Diagnostic> &one : found)
    if (one) diagnostics.push_back(std::move(*one));
  return diagnostics;
}

} // namespace symreal::program
