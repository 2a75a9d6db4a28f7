// A file that CMake embeds into a library or a program (cmake/embed.cmake).
#pragma once

#include <string_view>

namespace symreal {

struct Asset {
  std::string_view name; // "page/report.css"
  std::string_view text;
};

} // namespace symreal
