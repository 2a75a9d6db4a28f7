// Compiler flags of the variants in which a program is built, from those of the user.
#pragma once

#include "rewrite/request/request.h"

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

// Is the source in C, by -x or its extension?
bool is_c(rewrite::Compilation const &source);

// Do these flags enable a sanitizer, which replaces the allocation functions itself?
bool brings_allocator(std::vector<std::string> const &flags);

// The user's flags for a source that is compiled unchanged.
std::vector<std::string> unchanged_flags(std::vector<std::string> const &flags);

// The flags that may change numbers against the reference build.
std::vector<std::string> flags_of_numbers(std::vector<std::string> const &flags);

// Does the source count as C from before C99?
bool is_before_c99(std::vector<std::string> const &flags);

// Adds the flags of the reference build (docs/reference/floating-point.md).
void append_reference(std::vector<std::string> &flags);

inline void append(std::vector<std::string> &words, std::vector<std::string> const &more) {
  words.insert(words.end(), more.begin(), more.end());
}

} // namespace symreal::program
