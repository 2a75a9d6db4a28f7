#include "engine/analysis/scheduling/effort.h"

#include "engine/analysis/scheduling/exact.h"

#include <algorithm>

namespace symreal {
namespace {

std::size_t times_ten(std::size_t number, unsigned times) {
  for (; times != 0; --times) number *= 10;
  return number;
}

} // namespace

std::size_t Effort::search_steps(std::size_t tasks, std::size_t cost) const {
  if (level == 0 || tasks == 0 || tasks > most_searched_tasks) return 0;
  return std::min(times_ten(200, level - 1), times_ten(400'000, level - 1) / (tasks * cost));
}

std::uint64_t Effort::exact_nodes(std::size_t tasks) const {
  if (level == 0 || tasks > most_exact_tasks) return 0;
  if (tasks <= 30) return level == most_effort ? ~std::uint64_t{0} : times_ten(5'000'000, level - 1);
  return times_ten(200'000, level - 1);
}

} // namespace symreal
