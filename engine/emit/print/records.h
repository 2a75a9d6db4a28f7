// Elements that an iteration of a loop reads, or stores, beside each other, or code without a loop at indices that are
// long: the text names where they begin once, and says r1[2] for v[17914 - 54*k].
#pragma once

#include "engine/plan/reroll/loop_program.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace symreal {

struct Record {
  std::string array;
  std::int64_t first, step; // begins at first + step * iteration, the next one behind its elements
  bool is_stored;
};

class Records {
public:
  explicit Records(bool are_in_loop) : are_in_loop_(are_in_loop) {}

  void add(std::string const &array, reroll::Access const &access, bool is_stored);
  // When all are added: those with enough elements to be worth a name.
  void choose();

  std::vector<Record> const &chosen() const { return chosen_; }
  struct Place {
    std::size_t record;
    std::int64_t element;
  };
  std::optional<Place> find(std::string const &array, reroll::Access const &access, bool is_stored) const;

private:
  bool may_have(reroll::Access const &access) const;
  // From the first element of a record on, where its last one may be.
  std::int64_t span(std::int64_t step) const;

  bool are_in_loop_;
  std::map<std::tuple<std::string, std::int64_t, bool>, std::set<std::int64_t>> firsts_; // by array and step
  std::vector<Record> chosen_;
};

} // namespace symreal
