#include "emit/print/records.h"

#include <cmath>

namespace symreal {

static bool may_be_in_record(reroll::Access const &access) { return !access.is_listed() && std::abs(access.step) > 1; }

void Records::add(std::string const &array, reroll::Access const &access, bool is_stored) {
  if (may_be_in_record(access)) firsts_[{array, access.step, is_stored}].insert(access.first);
}

void Records::choose() {
  constexpr auto least_elements = 3;
  for (auto const &[key, firsts] : firsts_) {
    auto const &[array, step, is_stored] = key;
    for (auto begin = firsts.begin(); begin != firsts.end();) {
      auto const end = firsts.lower_bound(*begin + std::abs(step));
      if (std::distance(begin, end) >= least_elements) chosen_.push_back({array, *begin, step, is_stored});
      begin = end;
    }
  }
}

std::optional<Records::Place> Records::find(std::string const &array, reroll::Access const &access,
                                            bool is_stored) const {
  if (!may_be_in_record(access)) return {};
  for (std::size_t k = 0; k < chosen_.size(); ++k) {
    Record const &record = chosen_[k];
    std::int64_t const element = access.first - record.first;
    bool const is_inside = element >= 0 && element < std::abs(record.step);
    if (record.array == array && record.step == access.step && record.is_stored == is_stored && is_inside)
      return Place{k, element};
  }
  return {};
}

} // namespace symreal
