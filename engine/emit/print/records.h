// Records: groups of nearby elements that a loop iteration, or straight-line code at long indices, reads or stores. The
// text names the begin of a record once, and writes r1[2] for v[17914 - 54*k].
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
