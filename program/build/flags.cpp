#include "program/build/flags.h"

#include "rewrite/request/driver_options.h"

#include <algorithm>
#include <string_view>

namespace symreal::program {

using rewrite::About;
using rewrite::DriverOption;
using Words = std::vector<std::string>;

namespace {

// Flags of the reference build (docs/reference/floating-point.md), with debug information: lines and inlined calls.
Words const reference_flags = {
    "-O1",          "-g1",           "-ffp-contract=off", "-fno-tree-vectorize", "-fno-tree-slp-vectorize",
    "-fno-builtin", "-fno-fast-math"};
Words const defines = {"-DEIGEN_DONT_VECTORIZE"};

// Leaks are found because an operation on a node raises FE_INVALID: none may execute speculatively. gcc guarantees that
// by default, clang with this flag.
constexpr char const *no_speculation = "-ftrapping-math";

// The last standard among the flags; empty if none is given.
std::string named_standard(Words const &flags) {
  std::string standard;
  for (DriverOption const &option : rewrite::driver_options(flags))
    if (option.about == About::standard) standard = option.value.empty() ? "c90" : option.value; // -ansi
  return standard;
}

bool ends_with_one_of(std::string_view standard, std::initializer_list<std::string_view> years) {
  return std::ranges::any_of(years, [standard](std::string_view year) { return standard.ends_with(year); });
}

bool is_cxx20(std::string_view standard) {
  return ends_with_one_of(standard, {"++20", "++2a", "++23", "++2b", "++26", "++2c"});
}

// Raises an older standard to C++20, which the headers of symbolic mode need.
std::string symbolic_standard(std::string const &value) {
  if (is_cxx20(value)) return value;
  return value.starts_with("gnu") ? "gnu++20" : "c++20";
}

// Raises C++98 and C++03 to C++11, which the annotations need.
std::string annotated_standard(std::string const &value) {
  bool const old = value.ends_with("++98") || value.ends_with("++03");
  return old ? value.substr(0, value.size() - 2) + "11" : value;
}

} // namespace

bool is_c(rewrite::Compilation const &source) {
  bool c = source.source.ends_with(".c");
  for (DriverOption const &option : rewrite::driver_options(source.flags))
    if (option.about == About::language) c = option.value == "c";
  return c;
}

bool brings_allocator(Words const &words) {
  return std::ranges::any_of(rewrite::driver_options(words),
                             [](DriverOption const &option) { return option.about == About::sanitizers; });
}

bool is_before_c99(Words const &flags) { return ends_with_one_of(named_standard(flags), {"89", "90", "199409"}); }

void append_reference(Words &flags) {
  append(flags, reference_flags);
  append(flags, defines);
}

Words language_flags(Words const &flags, bool is_c, std::string const &compiler) {
  Words words;
  std::string const standard = named_standard(flags);
  if (is_c || !is_cxx20(standard)) words.emplace_back("-fno-char8_t");
  if (!is_c && !is_cxx20(standard)) words.emplace_back("-DSYMREAL_BEFORE_CXX20"); // for allocator.h
  if (compiler.find("clang") != compiler.npos) return words;
  constexpr char const *arguments_first = "-DSYMREAL_ARGUMENTS_FIRST"; // evaluated before the callee (text.h)
  if (is_c) append(words, {"-fno-strong-eval-order", arguments_first});
  if (is_c) return words;
  if (ends_with_one_of(standard, {"++98", "++03", "++0x", "++11", "++1y", "++14"}))
    append(words, {"-fstrong-eval-order=some", arguments_first});
  return words;
}

Words const &reference_defines() { return defines; }

Words variant_flags(Words const &flags, Variant variant) {
  Words words = adapted_flags(flags);
  append_reference(words);
  if (variant == Variant::symbolic) words.emplace_back(no_speculation);
  words.push_back("-w");
  words.emplace_back(variant == Variant::symbolic ? "-DMBD_SYMBOLIC" : "-DMBD_REPLAY");
  return words;
}

Words c_flags(Words const &flags) {
  Words words = original_flags(flags, Variant::original);
  append_reference(words);
  return words;
}

Words flags_of_numbers(Words const &flags) {
  Words found;
  for (DriverOption const &option : rewrite::driver_options(flags))
    if (option.about == About::numbers || option.about == About::machine) rewrite::append(found, option, flags);
  return found;
}

// Drops OpenMP, as one thread records a kernel; LTO, as objects are compiled separately; outputs, which the tool
// chooses; and warnings.
Words unchanged_flags(Words const &flags) {
  return rewrite::without(flags, {About::openmp, About::link_time, About::warnings, About::action, About::output,
                                  About::dependencies, About::question});
}

Words adapted_flags(Words const &flags) {
  Words const kept = original_flags(flags, Variant::replay);
  Words adapted;
  bool has_standard = false;
  for (DriverOption const &option : rewrite::driver_options(kept))
    if (option.about == About::standard) {
      has_standard = true;
      adapted.push_back("-std=" + symbolic_standard(option.value));
    } else
      rewrite::append(adapted, option, kept);
  if (!has_standard) adapted.emplace_back("-std=c++20");
  return adapted;
}

Words original_flags(Words const &flags, Variant variant) {
  Words const unchanged = unchanged_flags(flags);
  Words kept;
  for (DriverOption const &option : rewrite::driver_options(unchanged)) {
    if (option.about == About::numbers && variant != Variant::own_flags) continue;
    if (option.about == About::standard && !option.value.empty())
      kept.push_back("-std=" + annotated_standard(option.value));
    else
      rewrite::append(kept, option, unchanged);
  }
  return kept;
}

} // namespace symreal::program
