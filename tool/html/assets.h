// Files of the page, which CMake embeds into the tool (cmake/embed.cmake).
#pragma once

#include <span>
#include <string_view>

namespace symreal::tool {

struct Asset {
  std::string_view name; // "page/report.css"
  std::string_view text;
};

// All assets, the template first.
std::span<Asset const> assets();

} // namespace symreal::tool
