#include "program/build/compile.h"
#include "rewrite/request/driver_options.h"

#include <string_view>

namespace symreal::program {

using rewrite::About;
using rewrite::DriverOption;
using Words = std::vector<std::string>;

namespace {

// Raises an older standard to C++20, which the headers of symbolic mode need.
std::string symbolic_standard(std::string_view value) {
  for (std::string_view newer : {"++20", "++2a", "++23", "++2b", "++26", "++2c"})
    if (value.ends_with(newer)) return std::string(value);
  return value.starts_with("gnu") ? "gnu++20" : "c++20";
}

// Raises C++98 and C++03 to C++11, which the annotations need.
std::string annotated_standard(std::string const &value) {
  bool const old = value.ends_with("++98") || value.ends_with("++03");
  return old ? value.substr(0, value.size() - 2) + "11" : value;
}

} // namespace

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
