// Loop counters in the text of a step: k over all iterations; or i and j in a loop nest, with k beside them only if an
// index needs it.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/plan/reroll/nest.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace symreal {

// The affine index first + step * counter + ..., summed over steps and counters: 2*k + 5, or 5 - 2*k.
std::string index_text(std::int64_t first, std::vector<std::pair<std::int64_t, std::string_view>> const &steps);

class LoopIndices {
public:
  LoopIndices(Language const &language, reroll::Step const &step);

  bool is_loop() const { return count_ > 1; }
  bool is_nested() const { return nest_.has_value(); }
  std::set<std::string> const &names() const { return names_; }

  // Iteration count of the outer, or only, loop.
  std::uint32_t turns() const { return nest_ ? nest_->turns : count_; }
  // Counter of all iterations (k), and of the outer loop (i).
  std::string of_iteration();
  std::string of_turn() const;
  // Affine index of the element; nullopt if it needs an index table.
  std::optional<std::string> of_element(reroll::Access const &access);
  // Whether the index is invariant in all loops, or in the inner one.
  bool is_fixed(reroll::Access const &access) const;
  bool is_fixed_in_turn(reroll::Access const &access) const;

  // `of_turn`: statements of the outer loop. Returns the indentation of the body.
  std::size_t begin(std::vector<std::string> const &of_turn, CodeText &out) const;
  void end(CodeText &out) const;

private:
  std::optional<reroll::NestedAccess> nested(reroll::Access const &access) const;

  Language const &language_;
  std::uint32_t count_;
  std::optional<reroll::Nest> nest_ = {};
  std::set<std::string> names_ = {};
  bool is_counted_ = false; // whether an index needs k
};

} // namespace symreal
