// A pattern that is filled in again and again.
#pragma once

#include "engine/emit/language/language.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace symreal {

// Taken apart once, with the words of the language in their places.
class PreparedPattern {
public:
  // `names`: of its other places.
  PreparedPattern(Language const &language, std::string_view pattern, std::initializer_list<std::string_view> names);

  bool empty() const { return pieces_.empty(); }
  // `values`: in the order of the names.
  void append_to(std::string &text, std::initializer_list<std::string_view> values) const;

private:
  // Text, and behind it a value.
  struct Piece {
    std::string text;
    std::size_t value;
  };
  static constexpr std::size_t no_value = ~std::size_t{0};

  std::vector<Piece> pieces_;
};

} // namespace symreal
