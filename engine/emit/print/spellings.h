// Spellings in a language: of operations (the table of operations, with the language's exceptions), bridges and
// variables.
#pragma once

#include "engine/emit/language/language.h"
#include "engine/plan/plan.h"

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
  // The operation of two operands, given as text.
  std::string apply(Op op, std::string_view x, std::string_view y) const;

private:
  void make_single(Language const &language);

  std::array<Spelling, op_count> spellings_;
};

// Names of the functions' bridges, one per function of the graph; empty if the language has no bridges.
std::vector<std::string> bridge_names(Graph const &graph, Language const &language);

// Source names of values, with a number from the second use of a name on; t and a number for a value without a name.
// Distinct from each other and from the other names of the generated functions. Takes 8 bytes a variable.
class VariableNames {
public:
  VariableNames(Emission const &emission, PlanFunction const &body);

  void append_to(std::string &text, std::size_t variable) const;
  std::string operator()(std::size_t variable) const;

private:
  struct Entry {
    NameId name;
    std::uint32_t number;
  };
  void append_name(std::string &text, std::size_t variable) const;

  NameRules const *rules_;
  std::string (*written_)(std::string const &);
  std::vector<std::string> bases_; // per name of the graph
  std::vector<Entry> entries_;     // per variable; empty if no variable has a name
};

} // namespace symreal
