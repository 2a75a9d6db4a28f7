// Indices of elements in the text of a loop: its counters, affine indices, and records, the begins of groups of
// elements.
#pragma once

#include "engine/emit/print/code_text.h"
#include "engine/plan/loop_function.h"
#include "engine/plan/nest.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace symreal {

// The affine index first + step * counter + ..., summed over steps and counters: 2*k + 5, or 5 - 2*k.
std::string index_text(std::int64_t first, std::vector<std::pair<std::int64_t, std::string_view>> const &steps);

// Loop counters in the text of a step: k over all iterations; or i and j in a loop nest, with k beside them only if an
// index needs it.
class LoopIndices {
public:
  LoopIndices(Language const &language, reroll::LoopStep const &step);

  bool is_loop() const { return count_ > 1; }
  bool is_nested() const { return nest_.has_value(); }
  std::set<std::string> const &names() const { return names_; }

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

// Records: groups of nearby elements that a loop iteration, or straight-line code at long indices, reads or stores. The
// text names the begin of a record once, and writes r1[2] for v[17914 - 54*k].
struct Record {
  std::string array;
  std::int64_t first, step; // begins at first + step * iteration
  bool is_stored;
};

class Records {
public:
  explicit Records(bool are_in_loop) : are_in_loop_(are_in_loop) {}

  void add(std::string const &array, reroll::Access const &access, bool is_stored);
  // Chooses the records with enough elements to be worth a name, after all accesses are added.
  void choose();

  std::vector<Record> const &chosen() const { return chosen_; }
  struct Place {
    std::size_t record;
    std::int64_t element;
  };
  std::optional<Place> find(std::string const &array, reroll::Access const &access, bool is_stored) const;

private:
  bool may_have(reroll::Access const &access) const;
  // Maximum distance of an element from the first element of its record.
  std::int64_t span(std::int64_t step) const;

  bool are_in_loop_;
  std::map<std::tuple<std::string, std::int64_t, bool>, std::set<std::int64_t>> firsts_; // by array and step
  std::vector<Record> chosen_;
};

} // namespace symreal
