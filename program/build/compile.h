// Builds a program with the host's compilers, from the rewritten sources or from the annotated originals.
#pragma once

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

enum class Variant {
  symbolic,  // REAL is RealNumber: running the program records its kernels
  replay,    // rewritten text with REAL as double and live annotations: exposes changes by the rewriting
  original,  // annotated original, in its own language and standard: the reference of verification
  own_flags, // original with the user's flags instead of the reference build's
  wrapped,   // original with a wrapper's statements before those of the kernel
  covered,   // original built by clang with branch counters
  recorded   // original built by clang with the pass of oracle/: its instructions record themselves
};

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

// The user's flags adapted to rewritten text: drops options that change numbers, choose outputs or turn warnings into
// errors; turns a C standard into a C++ one; defaults to c++20.
std::vector<std::string> adapted_flags(std::vector<std::string> const &flags);

// The user's flags adapted to the original: the standard stays, except that C++98 becomes C++11. Variant::own_flags
// keeps the options that change numbers.
std::vector<std::string> original_flags(std::vector<std::string> const &flags, Variant variant);

// Flags of a rewritten source in the variant, including the user's; the runtime's headers are extra.
std::vector<std::string> variant_flags(std::vector<std::string> const &flags, Variant variant);

// Macros that all variants define. They affect what a source means, so the rewriter reads it with them.
std::vector<std::string> const &reference_defines();

// Flags that make a C++20 compiler accept a C or older C++ source with its own semantics. C++17 evaluates the right
// side of an assignment before the left, and an array before its index; C and older C++ leave the order open, and gcc
// reverses it there, while clang has one order for all. Before C++20, u8"text" has plain characters and char8_t is an
// ordinary name.
std::vector<std::string> language_flags(std::vector<std::string> const &flags, bool is_c, std::string const &compiler);

// Flags of a source that is compiled as C, in its own standard.
std::vector<std::string> c_flags(std::vector<std::string> const &flags);

// Command that compiles a rewritten source in one of the first two variants.
std::vector<std::string> rewritten_compilation(BuildRequest const &request, Variant variant, Overlay const &overlay,
                                               rewrite::Compilation const &source, std::string const &object);

// Command of a compiler whose messages are parsed: without colours and translations.
Command compiler_run(std::vector<std::string> words, std::string const &directory = {});

// Is the source in C, by -x or its extension?
bool is_c(rewrite::Compilation const &source);

// Do these flags enable a sanitizer, which replaces the allocation functions itself?
bool brings_allocator(std::vector<std::string> const &flags);

// The user's flags for a source that is compiled unchanged.
std::vector<std::string> unchanged_flags(std::vector<std::string> const &flags);

// The flags that may change numbers against the reference build.
std::vector<std::string> flags_of_numbers(std::vector<std::string> const &flags);

// Compiler of Variant::recorded and Variant::covered: the plugin and the coverage format require it.
inline constexpr char const *clang_compiler = "clang-19";

// Builds the program in each of the variants, with one compilation per processor at a time, and returns the
// executables' paths in the same order. Throws compiler_missing, build_failed or link_failed with places in the user's
// sources. `rewritten`: texts of the symbolic and replay variants; `annotated`: texts of the others.
std::vector<std::string> build_variants(BuildRequest const &request, std::span<Variant const> variants,
                                        Overlay const &rewritten, Overlay const &annotated, Workspace const &workspace);

} // namespace symreal::program
