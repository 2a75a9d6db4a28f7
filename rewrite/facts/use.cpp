#include "rewrite/facts/use.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace symreal::rewrite {
namespace {

using namespace trait;

constexpr std::array table = {
#define USE(name, payload, traits, text, what) UseInfo{#name, Payload::payload, traits, text},
#include "rewrite/facts/uses.def"
#undef USE
};

// Constraints on the order of the rows, which determines how uses nest.
constexpr bool stands_before(Use outer, Use inner) { return outer < inner; }
static_assert(stands_before(Use::as_width, Use::width));
static_assert(stands_before(Use::compound, Use::compound_list));
static_assert(stands_before(Use::range_begin, Use::range_end));
static_assert(stands_before(Use::fill_begin, Use::fill_end));
static_assert(stands_before(Use::cast, Use::conversion));
static_assert(std::is_partitioned(table.begin(), table.end(),
                                  [](UseInfo const &row) { return (row.traits & OUTERMOST) == 0; }));
static_assert(std::all_of(table.begin(), table.end(),
                          [](UseInfo const &row) { return row.text.find('$') != std::string_view::npos; }));

} // namespace

UseInfo const &info(Use use) { return table[static_cast<std::size_t>(use)]; }

std::optional<Use> find_use(std::string_view name) {
  auto const row = std::find_if(table.begin(), table.end(), [&](UseInfo const &one) { return one.name == name; });
  if (row == table.end()) return {};
  return static_cast<Use>(row - table.begin());
}

} // namespace symreal::rewrite
