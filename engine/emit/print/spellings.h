// Spellings of operations in a language: the table of operations, with the language's exceptions.
#pragma once

#include "engine/emit/language/language.h"

#include <array>
#include <string>
#include <vector>

namespace symreal {

inline constexpr std::size_t op_count = static_cast<std::size_t>(Op::count);

// Binding strengths, as in the table of operations.
namespace binding {
inline constexpr int loosest = 0, conditional_operand = 4, additive = 12, unary = 14, prefix_operand = 15;
}

class Spellings {
public:
  // Text, or an operand that needs parentheses unless it binds at least this tightly.
  struct Piece {
    std::string text;
    int operand = -1;
    int binding = binding::loosest;
  };
  struct Spelling {
    std::vector<Piece> pieces;
    int precedence = 0; // 0: needs no parentheses
  };

  explicit Spellings(Language const &language);

  Spelling const &operator[](Op op) const { return spellings_[static_cast<std::size_t>(op)]; }

  // The text of the spelling without its operands.
  std::string words(Op op) const;
  // The operation applied to operands given as text.
  std::string apply(Op op, std::string_view x, std::string_view y = {}, std::string_view z = {}) const;

private:
  void make_single(Language const &language);

  std::array<Spelling, op_count> spellings_;
};

} // namespace symreal
