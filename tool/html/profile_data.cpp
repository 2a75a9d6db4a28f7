#include "tool/html/data.h"

#include <algorithm>

namespace symreal::tool {

static Json thinned(LevelProfile const &profile, std::size_t step) {
  Json values = Json::array();
  for (std::size_t at = 0; at < profile.size(); at += step) {
    auto const first = profile.begin() + static_cast<std::ptrdiff_t>(at);
    values.push_back(
        *std::max_element(first, first + static_cast<std::ptrdiff_t>(std::min(step, profile.size() - at))));
  }
  return values;
}

Json profile_data(Figures const &figures) {
  constexpr std::size_t most_points = 20'000;
  std::size_t const length = std::max(figures.from_inputs.size(), figures.evened.size());
  std::size_t const step = std::max((length + most_points - 1) / most_points, std::size_t{1});
  return {{"step", step},
          {"from_inputs", thinned(figures.from_inputs, step)},
          {"from_outputs", thinned(figures.from_outputs, step)},
          {"levelled", thinned(figures.evened, step)}};
}

} // namespace symreal::tool
