// How a language spells each operation: the table of operations, and the language's exceptions to it.
#pragma once

#include "engine/emit/language/language.h"

#include <array>
#include <string>
#include <vector>

namespace symreal {

inline constexpr std::size_t op_count = static_cast<std::size_t>(Op::count);

// How tightly something binds, as the table of operations has it.
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

  // What stands in its spelling besides operands.
  std::string words(Op op) const;
  // The operation on operands that are text already.
  std::string apply(Op op, std::string_view x, std::string_view y = {}, std::string_view z = {}) const;

private:
  void make_single(Language const &language);

  std::array<Spelling, op_count> spellings_;
};

} // namespace symreal
