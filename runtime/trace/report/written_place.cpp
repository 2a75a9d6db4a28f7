#include "runtime/trace/report/written_place.h"

#include <charconv>

namespace symreal::trace {

Place written_place(std::string_view place) {
  std::string text(place);
  unsigned numbers[2] = {0, 0};
  for (unsigned &number : numbers) {
    std::size_t const colon = text.rfind(':');
    if (colon == std::string::npos) return {text, 0, 0};
    std::from_chars(text.data() + colon + 1, text.data() + text.size(), number);
    text.resize(colon);
  }
  return {text, numbers[1], numbers[0]};
}

} // namespace symreal::trace
