// Builds a program with the host's compilers, from the rewritten sources or from the annotated originals.
#pragma once

#include "program/build/flags.h"
#include "program/build/object_cache.h"
#include "program/build/overlay.h"
#include "program/build/process.h"
#include "program/build/workspace.h"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace symreal::program {

struct BuildRequest {
  std::vector<rewrite::Compilation> sources;        // with the user's compiler flags
  std::vector<rewrite::Compilation> unchanged = {}; // sources without rewriting, compiled unchanged
  std::vector<std::string> link;                    // additional linker arguments
  bool reachable = false; // link only what main reaches: other functions need definitions that are absent
  std::vector<std::string> called_from_outside = {}; // functions that generated code, loaded by the program, calls
  std::string type_name = rewrite::usual_type_name;  // name of the number type in rewritten sources
  std::string compiler = "c++", c_compiler = "cc";
  std::map<std::string, std::vector<std::string>> source_flags = {}; // additional flags of a source, by its real path
  std::map<std::string, double> reading_seconds = {};                // seconds that the rewriter read it, by real path
  // Reports a note about a source that is too large for the compiler.
  std::function<void(std::string const &)> note = [](std::string const &) {};
  // Cache of objects from earlier runs.
  std::shared_ptr<ObjectCache> cache = std::make_shared<ObjectCache>(std::make_shared<CacheDirectory>(""));
};

// Command that compiles a rewritten source in one of the first two variants.
std::vector<std::string> rewritten_compilation(BuildRequest const &request, Variant variant, Overlay const &overlay,
                                               rewrite::Compilation const &source, std::string const &object);

// Command of a compiler whose messages are parsed: without colours and translations.
Command compiler_run(std::vector<std::string> words, std::string const &directory = {});

// Compiler of Variant::recorded and Variant::covered: the plugin and the coverage format require it.
inline constexpr char const *clang_compiler = "clang-19";

// Builds the program in each of the variants, with one compilation per processor at a time, and returns the
// executables' paths in the same order. Throws compiler_missing, build_failed or link_failed with places in the user's
// sources. `rewritten`: texts of the symbolic and replay variants; `annotated`: texts of the others.
std::vector<std::string> build_variants(BuildRequest const &request, std::span<Variant const> variants,
                                        Overlay const &rewritten, Overlay const &annotated, Workspace const &workspace);

// Checks that each rewritten source compiles in symbolic mode: a compiler parses it and writes nothing. Returns one
// diagnostic for each source that fails, in the order of `request.sources`, with places in the user's sources.
// `rewritten`: their rewriting.
std::vector<Diagnostic> symbolic_check(BuildRequest request, rewrite::Result rewritten);

} // namespace symreal::program
