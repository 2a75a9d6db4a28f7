// Parser of a compiler's command line into options, with their words and topics, by the table of Clang's driver, which
// has gcc's options too.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace symreal::rewrite {

enum class About : unsigned char {
  input,        // a source, an object, a library's file
  output,       // -o
  action,       // -c, -S, -E, -fsyntax-only: where the compiler stops
  dependencies, // -MD and its like
  language,     // -x
  standard,     // -std, -ansi
  numbers,      // it may change them: -O2, -ffast-math, -ffp-contract=fast
  machine,      // -march=native and its like, which may change them too
  openmp,
  link_time,   // -flto
  warnings,    // -Wall, -pedantic
  directories, // where headers are searched: -I, -iquote, -isystem, -idirafter
  headers,     // -include, -imacros
  linking,     // -l, -L, -Wl, -pthread
  sanitizers,
  question, // nothing is compiled: --version, -print-search-dirs, -M
  other,
};

struct DriverOption {
  About about;
  std::string name;         // "-o", "-I", "-MF"; as it is written where Clang does not know it; empty for an input
  std::string value;        // its operand, in the same word or in the next
  std::size_t word, length; // the words that it is written in
};

std::vector<DriverOption> driver_options(std::span<std::string const> words);

// The option's words, behind those that are there.
void append(std::vector<std::string> &to, DriverOption const &option, std::span<std::string const> words);

// The words of the options that are not about any of these.
std::vector<std::string> without(std::vector<std::string> const &words, std::initializer_list<About> left_out);

} // namespace symreal::rewrite
