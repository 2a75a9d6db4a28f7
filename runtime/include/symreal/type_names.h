// Names of types, as the original has them: typeid(T).name(), __PRETTY_FUNCTION__ of a template. The rewriter puts
// these where a source asks for one.
#pragma once

#include <symreal/real_number.h>

#include <cstddef>
#include <typeinfo>

namespace symreal {

namespace detail {

struct TypeName {
  char const *ours, *original;
};
// Names as compilers print them; a name that is a prefix of another follows it.
inline constexpr TypeName type_names[] = {
    {"; symreal::SymrealReal = symreal::types::RealNumber", ""},
    {"symreal::SymrealReal = symreal::types::RealNumber; ", ""},
    {" [with symreal::SymrealReal = symreal::types::RealNumber]", ""},
    {"symreal::types::RealNumber", "double"},
    {"::symreal::SymrealReal", "double"},
    {"symreal::SymrealReal", "double"},
    {"symreal::types::SymbolicBool", "bool"},
    {"operator RealNumber()", "operator double()"}, // clang
};
inline constexpr char integer_name[] = "symreal::types::SymbolicInt<"; // int>

// Length of `name` if the text begins with it, else 0.
constexpr std::size_t beginning(char const *text, char const *name) {
  std::size_t length = 0;
  for (; name[length] != '\0'; ++length)
    if (text[length] != name[length]) return 0;
  return length;
}

// Writes the original's spelling of the text to `to`, which must have room for it; returns its length.
constexpr std::size_t original_name(char const *text, char *to) {
  std::size_t length = 0;
  while (*text != '\0') {
    std::size_t taken = 0;
    for (TypeName const &name : type_names) {
      taken = beginning(text, name.ours);
      if (taken == 0) continue;
      for (char const *letter = name.original; *letter != '\0'; ++letter) to[length++] = *letter;
      break;
    }
    if (taken == 0 && (taken = beginning(text, integer_name)) != 0) {
      while (text[taken] != '>') to[length++] = text[taken++];
      ++taken;
    }
    if (taken == 0) {
      to[length++] = *text;
      taken = 1;
    }
    text += taken;
  }
  return length;
}

char const *named(char const *text) noexcept;
void give_name(char const *mangled, char const *place) noexcept;
std::type_info const &named(std::type_info const &type, char const *place) noexcept;

} // namespace detail

// The value of __PRETTY_FUNCTION__.
template <std::size_t size> struct SymrealSignature {
  char symreal_letters[size] = {};
  std::size_t symreal_length = 0;
  constexpr SymrealSignature(char const (&text)[size]) : symreal_length(detail::original_name(text, symreal_letters)) {
    for (std::size_t k = symreal_length; k < size; ++k) symreal_letters[k] = '\0';
  }
};
// The text in an array of its exact length, as in the original.
template <SymrealSignature signature> struct SymrealNamed {
  char symreal_letters[signature.symreal_length + 1] = {};
  constexpr SymrealNamed() {
    for (std::size_t k = 0; k < signature.symreal_length; ++k) symreal_letters[k] = signature.symreal_letters[k];
  }
};
template <SymrealSignature signature> inline constexpr SymrealNamed<signature> symreal_signature;

// A type whose name may be read at `place`. detail::named() is opaque to the compiler, which would otherwise fold the
// name that it knows.
constexpr std::type_info const &symreal_named(std::type_info const &type, char const *place) noexcept {
  return __builtin_is_constant_evaluated() ? type : detail::named(type, place);
}
inline std::type_info const *symreal_named(std::type_info const *type, char const *place) noexcept {
  return &detail::named(*type, place);
}
// std::type_index
template <class Index>
  requires requires(Index const &index) { index.hash_code(); }
Index symreal_named(Index index, char const *place) noexcept {
  detail::give_name(index.name(), place);
  return index;
}
// std::source_location::function_name()
constexpr char const *symreal_named(char const *text, char const *) noexcept {
  return __builtin_is_constant_evaluated() ? text : detail::named(text);
}

} // namespace symreal
