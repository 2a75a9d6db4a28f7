#include "engine/emit/print/records.h"

#include <cmath>

namespace symreal {

bool Records::may_have(reroll::Access const &access) const {
  constexpr std::int64_t long_index = 1000;
  if (access.is_listed()) return false;
  return are_in_loop_ ? std::abs(access.step) > 1 : access.step == 0 && access.first >= long_index;
}

std::int64_t Records::span(std::int64_t step) const {
  constexpr std::int64_t most_elements = 64; // in straight-line code
  return are_in_loop_ ? std::abs(step) : most_elements;
}

void Records::add(std::string const &array, reroll::Access const &access, bool is_stored) {
  if (may_have(access)) firsts_[{array, access.step, is_stored}].insert(access.first);
}

void Records::choose() {
  auto const least_elements = are_in_loop_ ? 3 : 16;
  for (auto const &[key, firsts] : firsts_) {
    auto const &[array, step, is_stored] = key;
    for (auto begin = firsts.begin(); begin != firsts.end();) {
      auto const end = firsts.lower_bound(*begin + span(step));
      if (std::distance(begin, end) >= least_elements) chosen_.push_back({array, *begin, step, is_stored});
      begin = end;
    }
  }
}

std::optional<Records::Place> Records::find(std::string const &array, reroll::Access const &access,
                                            bool is_stored) const {
  if (!may_have(access)) return {};
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    Record const &record = chosen_[k];
    std::int64_t const element = access.first - record.first;
    bool const is_inside = element >= 0 && element < span(record.step);
    if (record.array == array && record.step == access.step && record.is_stored == is_stored && is_inside)
      return Place{k, element};
  }
  return {};
}

} // namespace symreal
