// Builds a program of the user's sources with the host's compilers: of the rewritten ones, or of the originals with
// their annotations alone.
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
  symbolic,  // REAL is a RealNumber: running the program records its kernels
  replay,    // the rewritten text, REAL is double and the annotations are live: shows what rewriting has changed
  original,  // the user's text with its annotations, in its own language and standard: the reference of verification
  own_flags, // the original with the user's own flags instead of those of the reference build
  wrapped,   // the original with the statements of a kernel's wrapper before those of the kernel
  covered,   // the original, by clang, which counts how often each branch goes which way
  recorded   // the original, by clang with the pass of oracle/: its instructions record themselves
};

struct BuildRequest {
  std::vector<rewrite::Compilation> sources;        // with the user's compiler flags
  std::vector<rewrite::Compilation> unchanged = {}; // sources that nothing rewrites: compiled as they are
  std::vector<std::string> link;                    // further words for the linker
  bool reachable = false; // the program is linked of what main reaches: other functions need what is not there
  std::vector<std::string> called_from_outside = {}; // of the program's functions, by generated code that it loads
  std::string type_name = rewrite::usual_type_name;  // how the rewritten sources spell the number
  std::string compiler = "c++", c_compiler = "cc";
  std::map<std::string, std::vector<std::string>> source_flags = {}; // of a source besides, by its real path
  std::map<std::string, double> reading_seconds = {};                // that the rewriter took for it, likewise
  // What the user is told of a source that is too large for the compiler.
  std::function<void(std::string const &)> note = [](std::string const &) {};
  // Where objects of earlier runs may be.
  std::shared_ptr<ObjectCache> cache = std::make_shared<ObjectCache>(std::make_shared<CacheDirectory>(""));
};

// What becomes of the user's flags where rewritten text is compiled: options that change the numbers, choose outputs or
// turn warnings into errors go, a C standard becomes a C++ one, and c++20 is the default.
std::vector<std::string> adapted_flags(std::vector<std::string> const &flags);

// The same where the original is compiled: the standard stays, but for C++98, which gives way to C++11. What changes
// the numbers stays in Variant::own_flags.
std::vector<std::string> original_flags(std::vector<std::string> const &flags, Variant variant);

// How a rewritten source is compiled in the variant, with the user's flags in it; needs the runtime's headers besides.
std::vector<std::string> variant_flags(std::vector<std::string> const &flags, Variant variant);

// The macros among these flags. They decide what a source is, so the rewriter reads it with them.
std::vector<std::string> const &reference_defines();

// What a compiler of C++20 must be told besides, so that it takes a source of C or of older C++ as theirs does.
// C++17 says that the right side of an assignment is evaluated before the left one, and an index after what it is of. C
// and older C++ leave it open, and gcc goes the other way there; clang has one order for all. And before C++20,
// u8"text" is of plain characters, and char8_t a name like others.
std::vector<std::string> language_flags(std::vector<std::string> const &flags, bool is_c, std::string const &compiler);

// How a source in C that stays one is compiled, in its own standard.
std::vector<std::string> c_flags(std::vector<std::string> const &flags);

// The command that makes the object of a rewritten source in one of the first two variants.
std::vector<std::string> rewritten_compilation(BuildRequest const &request, Variant variant, Overlay const &overlay,
                                               rewrite::Compilation const &source, std::string const &object);

// A run of a compiler whose messages a program reads.
Command compiler_run(std::vector<std::string> words, std::string const &directory = {});

// Is the source one in C, by -x or by its name?
bool is_c(rewrite::Compilation const &source);

// Do these flags bring a sanitizer? It replaces the allocation functions itself.
bool brings_allocator(std::vector<std::string> const &flags);

// What is left of the user's flags for a source that is compiled as it is.
std::vector<std::string> unchanged_flags(std::vector<std::string> const &flags);

// Those with which a build may give other numbers than the reference build.
std::vector<std::string> flags_of_numbers(std::vector<std::string> const &flags);

// Of Variant::recorded and Variant::covered: the one that the plugin is for, and whose form of coverage is read here.
inline constexpr char const *clang_compiler = "clang-19";

// Builds the program in each of the variants, as many compilations at a time as there are
// processors, and returns the paths of the executables in
// the same order. Throws compiler_missing, build_failed or link_failed with places in the user's sources.
// `rewritten` and `annotated`: the texts of the one and of the other two variants.
std::vector<std::string> build_variants(BuildRequest const &request, std::span<Variant const> variants,
                                        Overlay const &rewritten, Overlay const &annotated, Workspace const &workspace);

} // namespace symreal::program
