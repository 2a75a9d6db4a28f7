#include "tool/report/number_list.h"

#include "engine/support/number.h"

namespace symreal::tool {

std::string number_list(std::vector<double> const &values) {
  constexpr std::size_t most = 16;
  std::string text;
  for (std::size_t i = 0; i < values.size() && i < most; ++i) text += (i ? ", " : "") + shortest(values[i]);
  return values.size() > most ? text + ", ..." : text;
}

} // namespace symreal::tool
