// How the text of a step counts its iterations: k through all of them; or i and j in two loops, one in the other, and k
// beside them only where something goes by it.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/plan/reroll/nest.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace symreal {

// The text of first + step * counter + ... for each step and counter: 2*k + 5, or 5 - 2*k.
std::string index_text(std::int64_t first, std::vector<std::pair<std::int64_t, std::string_view>> const &steps);

class LoopIndices {
public:
  LoopIndices(Language const &language, reroll::Step const &step);

  bool is_loop() const { return count_ > 1; }
  bool is_nested() const { return nest_.has_value(); }
  std::set<std::string> const &names() const { return names_; }

  // How often the outer of two loops goes round, or the only one.
  std::uint32_t turns() const { return nest_ ? nest_->turns : count_; }
  // k, and i of two loops.
  std::string of_iteration();
  std::string of_turn() const;
  // Of an element; none where only a table says it.
  std::optional<std::string> of_element(reroll::Access const &access);
  // Whether it stays the same in all iterations, and while the inner of two loops goes round.
  bool is_fixed(reroll::Access const &access) const;
  bool is_fixed_in_turn(reroll::Access const &access) const;

  // `of_turn`: statements of the outer loop. Returns how far the body is indented.
  std::size_t begin(std::vector<std::string> const &of_turn, CodeText &out) const;
  void end(CodeText &out) const;

private:
  std::optional<reroll::NestedAccess> nested(reroll::Access const &access) const;

  Language const &language_;
  std::uint32_t count_;
  std::optional<reroll::Nest> nest_ = {};
  std::set<std::string> names_ = {};
  bool is_counted_ = false; // something goes by k
};

} // namespace symreal
