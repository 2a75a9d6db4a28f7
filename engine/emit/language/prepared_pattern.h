// Prepared patterns, for repeated filling.
#pragma once

#include "engine/emit/language/language.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// A pattern parsed once, with the language's words filled in.
class PreparedPattern {
public:
  // `names`: the remaining placeholders.
  PreparedPattern(Language const &language, std::string_view pattern, std::initializer_list<std::string_view> names);

  bool empty() const { return pieces_.empty(); }
  // `values`: in the order of `names`.
  void append_to(std::string &text, std::initializer_list<std::string_view> values) const;

private:
  // Text, followed by a value.
  struct Piece {
    std::string text;
    std::size_t value;
  };
  static constexpr std::size_t no_value = ~std::size_t{0};

  std::vector<Piece> pieces_;
};

} // namespace symreal
