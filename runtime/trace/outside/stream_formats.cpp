#include "runtime/trace/outside/stream_formats.h"

#include <iostream>
#include <utility>

namespace symreal::trace {

static constexpr std::array<char const *, 4> names = {"std::cin", "std::cout", "std::cerr", "std::clog"};
static std::array<std::ios *, 4> streams() { return {&std::cin, &std::cout, &std::cerr, &std::clog}; }

StreamFormats read_formats() {
  StreamFormats formats;
  for (std::size_t k = 0; std::ios const *stream : streams())
    formats[k++] = {stream->flags(), stream->precision(), stream->width(), stream->fill()};
  return formats;
}

std::vector<std::string> changed_formats(StreamFormats const &before) {
  std::vector<std::string> changed;
  StreamFormats const now = read_formats();
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] != before[k]) changed.emplace_back(names[k]);
  return changed;
}

void change_formats() {
  for (std::ios *stream : streams()) {
    stream->setf(std::ios_base::showpos);
    stream->precision(stream->precision() + 3);
    stream->width(stream->width() + 7);
    stream->fill('#');
  }
}

} // namespace symreal::trace
